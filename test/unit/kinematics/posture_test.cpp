// In which turn a joint is.

#include "cobot_command/kinematics/posture.h"

#include <gtest/gtest.h>

namespace cobot_command::kinematics {
namespace {

TEST(Turns, countFromTheTurnAroundZero) {
  EXPECT_EQ(turnsOf({0, 179.9, 180, 180.1, 270, 540}), (Turns{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(turnsOf({-0.0, -179.9, -180, -180.1, -270, -540}), (Turns{0, 0, -1, -1, -1, -2}));
}

TEST(Turns, areNotChangedByWhatRoundingLeavesBehind) {
  arm::JointVector joints = arm::toJointVector({180, -179.999, 90, 0, 0, 180});
  joints[5] += 1e-15;
  EXPECT_EQ(postureOf(joints, {}).turns, (Turns{0, 0, 0, 0, 0, 0}));
}

TEST(APosture, isToldInDegreesAsItWasGiven) {
  const arm::ControllerJoints joints = {30.1, -20.7, 100.3, 10.9, 80.2, -45.6};
  EXPECT_EQ(postureOf(arm::toJointVector(joints), {}).joints, joints);
}

}  // namespace
}  // namespace cobot_command::kinematics
