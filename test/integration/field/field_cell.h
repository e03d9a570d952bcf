// A TM5-900 that stands at J = 0 0 90 0 90 0, as a controller in the field is.
#pragma once

#include "core_and_robot.h"
#include "motion_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// At 50 % of 180 deg/s, with 0.2 s to that.
inline blocks::MoveAbsoluteGoal turnTo(double j1, double speed_percent = 50) {
  return moveJoints({j1, 0, 90, 0, 90, 0}, speed_percent);
}

inline blocks::Outcome endOf(CoreAndRobot& cell, const blocks::Goal& goal) {
  return cell.endOf(cell.submit(goal));
}

}  // namespace cobot_command::testing
