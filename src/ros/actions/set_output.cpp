#include "cobot_command/blocks/set_output.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/SetOutputAction.h"

namespace cobot_command::ros_adapter {

blocks::SetOutputGoal toGoal(const cobot_command::SetOutputGoal& message, const Lookups& /*lookups*/) {
  return {message.kind,  message.module,       message.output,
          message.value, message.at_once != 0, message.buffer_mode};
}

void fill(cobot_command::SetOutputResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  fillEnd(message, outcome);
}

void fill(cobot_command::SetOutputFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
}

template <>
struct ActionOf<blocks::SetOutputGoal> {
  using Type = cobot_command::SetOutputAction;
};
template std::unique_ptr<GoalListener> serve<blocks::SetOutputGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
