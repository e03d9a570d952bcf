#include "cobot_command/blocks/move_circle.h"

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/MoveCircleAction.h"

namespace cobot_command::ros_adapter {

blocks::MoveCircleGoal toGoal(const cobot_command::MoveCircleGoal& message, const Lookups& lookups) {
  blocks::MoveCircleGoal goal;
  takeMotion(goal, message);
  goal.arc_point = toSix(message.arc_point);
  goal.end_point = toSix(message.end_point);
  goal.arc_pose = toFramedPose(message.arc_pose, lookups.frames);
  goal.end_pose = toFramedPose(message.end_pose, lookups.frames);
  goal.arc_angle = message.arc_angle;
  return goal;
}

void fill(cobot_command::MoveCircleResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillMoveEnd(message, outcome, site.joint_names);
}

void fill(cobot_command::MoveCircleFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillMotion(message, progress);
}

template <>
struct ActionOf<blocks::MoveCircleGoal> {
  using Type = cobot_command::MoveCircleAction;
};
template std::unique_ptr<GoalListener> serve<blocks::MoveCircleGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
