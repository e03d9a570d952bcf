#include "cobot_command/blocks/stop.h"

#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/StopAction.h"

namespace cobot_command::ros_adapter {

blocks::StopGoal toGoal(const cobot_command::StopGoal& /*message*/, const Lookups& /*lookups*/) {
  return {};
}

void fill(cobot_command::StopResult& message, const blocks::Outcome& outcome, const FillSite& /*site*/) {
  fillEnd(message, outcome);
}

void fill(cobot_command::StopFeedback& message, const blocks::Progress& progress, const FillSite& /*site*/) {
  fillPhase(message, progress);
}

template <>
struct ActionOf<blocks::StopGoal> {
  using Type = cobot_command::StopAction;
};
template std::unique_ptr<GoalListener> serve<blocks::StopGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
