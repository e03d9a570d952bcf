#include "cobot_command/blocks/change_base.h"

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/ChangeBaseAction.h"

namespace cobot_command::ros_adapter {

blocks::ChangeBaseGoal toGoal(const cobot_command::ChangeBaseGoal& message, const Lookups& lookups) {
  blocks::ChangeBaseGoal goal;
  takeCommand(goal, message);
  goal.transformation = toSix(message.transformation);
  goal.base_pose = toFramedPose(message.base_pose, lookups.frames);
  goal.base_name = message.base_name;
  return goal;
}

void fill(cobot_command::ChangeBaseResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  fillCommandEnd(message, outcome);
}

void fill(cobot_command::ChangeBaseFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillCommandTurn(message, progress);
}

template <>
struct ActionOf<blocks::ChangeBaseGoal> {
  using Type = cobot_command::ChangeBaseAction;
};
template std::unique_ptr<GoalListener> serve<blocks::ChangeBaseGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
