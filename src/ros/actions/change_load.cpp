#include "cobot_command/blocks/change_load.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ChangeLoadAction.h"

namespace cobot_command::ros_adapter {

blocks::ChangeLoadGoal toGoal(const cobot_command::ChangeLoadGoal& message, const Lookups& /*lookups*/) {
  return {message.weight, message.buffer_mode};
}

void fill(cobot_command::ChangeLoadResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillEnd(message, outcome);
}

void fill(cobot_command::ChangeLoadFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
}

template <>
struct ActionOf<blocks::ChangeLoadGoal> {
  using Type = cobot_command::ChangeLoadAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ChangeLoadGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
