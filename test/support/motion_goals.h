// Goals of motions that tests of the whole chain send.
#pragma once

#include <array>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {

/// A PTP to these joints.
inline blocks::MoveAbsoluteGoal moveJoints(const std::array<double, 6>& joints_deg,
                                           double speed_percent = 50) {
  blocks::MoveAbsoluteGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Ptp);
  goal.data_format = static_cast<int>(blocks::AbsoluteFormat::Jpp);
  goal.target = joints_deg;
  goal.speed = speed_percent;
  goal.accel_time = 200;
  return goal;
}

}  // namespace cobot_command::testing
