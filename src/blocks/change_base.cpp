// CBT_ChangeBase (thesis 5.3.5).

#include "framed_pose.h"
#include "parameter_checks.h"

namespace cobot_command::blocks {

CommandTraits traitsOf(const ChangeBaseGoal& goal) {
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

/// A base is measured in the robot base, whichever base is active.
script::ScriptCommand commandOf(const ChangeBaseGoal& goal, const arm::Pose& /*base*/) {
  if (!goal.base_name.empty()) return script::ChangeBase{goal.base_name};
  return script::ChangeBase{targetOf(goal.transformation, goal.base_pose, arm::Pose::Identity())};
}

}  // namespace cobot_command::blocks
