#include "cobot_command/blocks/change_base.h"

#include "shared/framed_pose.h"
#include "shared/moved_frames.h"
#include "shared/parameter_checks.h"

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {

ErrorTable ChangeBaseGoal::errors() {
  return ErrorTable().thesisCommand().echoedCommandId().anyCommand().turn().inCell().framedPose().shared(
      {own_error::kNotFinite, own_error::kCoordinateRange, own_error::kNameInvalid});
}

GoalTraits traitsOf(const ChangeBaseGoal& goal) {
  return traitsOfCommand(goal);
}

std::vector<Failure> check(const ChangeBaseGoal& goal) {
  ParameterChecks checks;
  checks.commandId(goal.command_id, kNoCommandId);
  checks.bufferMode(goal.buffer_mode);
  if (!goal.base_name.empty()) {
    checks.name("base_name", goal.base_name);
  } else if (goal.base_pose) {
    checkPose(checks, "base_pose", *goal.base_pose);
  } else {
    checks.sixValues("transformation", goal.transformation);
  }
  return std::move(checks).violations();
}

std::optional<Failure> findMovedFrame(const ChangeBaseGoal& goal, const FrameFinder& finder) {
  return findMovedFrame("base_pose", goal.base_pose, finder);
}

/// A base is measured in the robot base, whichever base is active.
Order orderOf(const ChangeBaseGoal& goal, const arm::Pose& /*base*/) {
  if (!goal.base_name.empty()) return settingOrder(script::ChangeBase{goal.base_name});
  return settingOrder(
      script::ChangeBase{targetOf(goal.transformation, goal.base_pose, arm::Pose::Identity())});
}

}  // namespace cobot_command::blocks
