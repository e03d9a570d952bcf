#include "cobot_command/blocks/move_relative.h"

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"
#include "action_parts/step_goals.h"

#include "cobot_command/MoveRelativeAction.h"

namespace cobot_command::ros_adapter {

blocks::MoveRelativeGoal toGoal(const cobot_command::MoveRelativeGoal& message, const Lookups& /*lookups*/) {
  blocks::MoveRelativeGoal goal;
  takeMotion(goal, message);
  takeTarget(goal, message);
  return goal;
}

void fill(cobot_command::MoveRelativeResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillMoveEnd(message, outcome, site.joint_names);
}

void fill(cobot_command::MoveRelativeFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillMotion(message, progress);
}

template <>
struct ActionOf<blocks::MoveRelativeGoal> {
  using Type = cobot_command::MoveRelativeAction;
};
template std::unique_ptr<GoalListener> serve<blocks::MoveRelativeGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
