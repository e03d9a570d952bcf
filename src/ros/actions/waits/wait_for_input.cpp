#include "cobot_command/blocks/waits/wait_for_input.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/WaitForInputAction.h"

namespace cobot_command::ros_adapter {

blocks::WaitForInputGoal toGoal(const cobot_command::WaitForInputGoal& message, const Lookups& /*lookups*/) {
  return {message.module, message.input, message.value != 0, message.timeout, message.buffer_mode};
}

void fill(cobot_command::WaitForInputResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillEnd(message, outcome);
  message.actual_duration = toRos(outcome.actual);
}

void fill(cobot_command::WaitForInputFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
}

template <>
struct ActionOf<blocks::WaitForInputGoal> {
  using Type = cobot_command::WaitForInputAction;
};
template std::unique_ptr<GoalListener> serve<blocks::WaitForInputGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
