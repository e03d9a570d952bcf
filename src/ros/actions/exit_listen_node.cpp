#include "cobot_command/blocks/exit_listen_node.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/ExitListenNodeAction.h"

namespace cobot_command::ros_adapter {

blocks::ExitListenNodeGoal toGoal(const cobot_command::ExitListenNodeGoal& message,
                                  const Lookups& /*lookups*/) {
  return {message.buffer_mode};
}

void fill(cobot_command::ExitListenNodeResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillEnd(message, outcome);
}

void fill(cobot_command::ExitListenNodeFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
}

template <>
struct ActionOf<blocks::ExitListenNodeGoal> {
  using Type = cobot_command::ExitListenNodeAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ExitListenNodeGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
