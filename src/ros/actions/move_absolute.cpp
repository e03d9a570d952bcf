#include "cobot_command/blocks/move_absolute.h"

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/MoveAbsoluteAction.h"

namespace cobot_command::ros_adapter {

blocks::MoveAbsoluteGoal toGoal(const cobot_command::MoveAbsoluteGoal& message, const Lookups& lookups) {
  blocks::MoveAbsoluteGoal goal;
  takeMotion(goal, message);
  takeTarget(goal, message);
  goal.target_pose = toFramedPose(message.target_pose, lookups.frames);
  goal.robot_pose_enable = message.robot_pose_enable != 0;
  goal.robot_pose = {message.robot_pose.config1, message.robot_pose.config2, message.robot_pose.config3};
  return goal;
}

void fill(cobot_command::MoveAbsoluteResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillMoveEnd(message, outcome, site.joint_names);
}

void fill(cobot_command::MoveAbsoluteFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillMotion(message, progress);
}

template <>
struct ActionOf<blocks::MoveAbsoluteGoal> {
  using Type = cobot_command::MoveAbsoluteAction;
};
template std::unique_ptr<GoalListener> serve<blocks::MoveAbsoluteGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
