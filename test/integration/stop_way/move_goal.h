// Goals for moves of the first joint, for the tests that stop them.
#pragma once

#include "cobot_command/MoveAbsoluteActionGoal.h"

namespace cobot_command::testing {

/// By PTP, from where the arm starts, to that angle [deg].
[[nodiscard]] inline cobot_command::MoveAbsoluteActionGoal moveOf(double joint) {
  cobot_command::MoveAbsoluteActionGoal goal;
  goal.goal.movement_command = cobot_command::MoveAbsoluteGoal::PTP;
  goal.goal.target_position.x = joint;
  goal.goal.target_position.z = 90;
  goal.goal.target_position.ry = 90;
  goal.goal.speed = 50;
  goal.goal.accel_time = 300;
  return goal;
}

/// The same, queued after the running ones.
[[nodiscard]] inline cobot_command::MoveAbsoluteActionGoal bufferedMoveOf(double joint) {
  auto goal = moveOf(joint);
  goal.goal.buffer_mode = 1;
  return goal;
}

}  // namespace cobot_command::testing
