// Whether a robot stands, by its joint speeds, and by its joint angles where the speeds are noise, or none.

#include "cobot_command/robot/standstill.h"

#include <gtest/gtest.h>

#include "cobot_command/common/units.h"

namespace cobot_command::robot {
namespace {

using namespace std::chrono_literals;

struct Robot {
  Standstill standstill;
  Instant now{1s};

  void frame(double j1_deg, std::optional<double> speed_deg = std::nullopt, Duration later = 15ms) {
    now += later;
    link::RobotStatus status;
    status.received = now;
    status.joints = arm::JointVector::Zero();
    (*status.joints)[0] = degToRad(j1_deg);
    if (speed_deg) {
      status.joint_velocities = arm::JointVector::Zero();
      (*status.joint_velocities)[0] = degToRad(*speed_deg);
    }
    standstill.see(status);
  }
  std::optional<bool> moving() const { return standstill.moving(); }
};

TEST(Standstill, isToldByTheJointSpeedsWhereTheyAreNextToNothingOrAboveAnyNoise) {
  Robot robot;
  EXPECT_EQ(robot.moving(), std::nullopt);
  robot.frame(0, 2.0);
  EXPECT_EQ(robot.moving(), true);
  robot.frame(10, -0.05);
  EXPECT_EQ(robot.moving(), false) << "whatever the angles are";
}

TEST(Standstill, isToldByTheJointAnglesWhereTheSpeedsAreNoise) {
  Robot robot;
  robot.frame(0, 0.3);
  EXPECT_EQ(robot.moving(), std::nullopt) << "of one frame nobody can say";
  for (int i = 0; i < 20; ++i) robot.frame(0.01 * (i % 2), i % 2 == 0 ? 0.3 : -0.5);
  EXPECT_EQ(robot.moving(), false);
  for (int i = 1; i <= 5; ++i) robot.frame(0.012 * i, 0.8);
  EXPECT_EQ(robot.moving(), true);
}

/// A motion that begins, or ends, is slow: a stop that is over while the arm still creeps is no stop.
TEST(Standstill, endsAtOnceWithASpeedThatThisArmNeverHadAtRest) {
  Robot quiet;
  quiet.frame(0, 0.0);
  quiet.frame(0.001, 0.2);
  EXPECT_EQ(quiet.moving(), true);
  quiet.frame(0.002, 0.15);
  EXPECT_EQ(quiet.moving(), true);
  quiet.frame(0.002, 0.02);
  EXPECT_EQ(quiet.moving(), false);

  Robot noisy;
  for (int i = 0; i < 22; ++i) noisy.frame(0.01 * (i % 2), 0.4);
  ASSERT_EQ(noisy.moving(), false);
  noisy.frame(0, 0.5);
  EXPECT_EQ(noisy.moving(), false);
  noisy.frame(0.01, 0.7);
  EXPECT_EQ(noisy.moving(), true);
}

TEST(Standstill, learnsNoNoiseOfAnArmThatBrakes) {
  Robot robot;
  double angle = 0;
  for (double speed = 30; speed > 0.4; speed -= 1.5) {  // 100 degrees a second squared, each 15 ms
    robot.frame(angle += 0.015 * speed, speed);
  }
  while (robot.moving() == true) robot.frame(angle, 0.2);
  robot.frame(angle, 0.4);
  EXPECT_EQ(robot.moving(), true);
}

TEST(Standstill, learnsOfMoreNoiseByTheJointAngles) {
  Robot robot;
  robot.frame(0, 0.0);
  for (int i = 0; i < 20; ++i) {
    robot.frame(0.01 * (i % 2), 0.4);
    EXPECT_EQ(robot.moving(), true);
  }
  robot.frame(0, 0.4);
  EXPECT_EQ(robot.moving(), false);
  robot.frame(0, 0.02);
  robot.frame(0, 0.5);
  EXPECT_EQ(robot.moving(), false) << "known by now";
}

TEST(Standstill, isToldByTheJointSpeedsAloneWhereThereAreNoAngles) {
  Robot robot;
  link::RobotStatus status;
  status.joint_velocities = arm::JointVector::Constant(degToRad(0.3));
  robot.standstill.see(status);
  EXPECT_EQ(robot.moving(), true);
}

/// No joint moved by more than 0.05 degrees within 0.3 s.
TEST(Standstill, isToldByTheJointAnglesWhereThereAreNoSpeeds) {
  Robot robot;
  robot.frame(0);
  EXPECT_EQ(robot.moving(), std::nullopt) << "of one frame nobody can say";
  robot.frame(0.1);
  EXPECT_EQ(robot.moving(), true);
  for (int i = 0; i < 19; ++i) robot.frame(0.1);
  EXPECT_EQ(robot.moving(), true) << "285 ms";
  robot.frame(0.1);
  EXPECT_EQ(robot.moving(), false);
  robot.frame(0.14);
  EXPECT_EQ(robot.moving(), false);
  robot.frame(0.16);
  EXPECT_EQ(robot.moving(), true);
}

TEST(Standstill, isNotTakenFromTwoFramesThatTheNetworkHeldBack) {
  Robot robot;
  robot.frame(0);
  robot.frame(0.5);
  robot.frame(0.51, std::nullopt, 500ms);
  EXPECT_EQ(robot.moving(), true);
  robot.frame(0.58, std::nullopt, 0ms);
  EXPECT_EQ(robot.moving(), true);
}

TEST(Standstill, seesASlowMotionThatHardlyChangesFromFrameToFrame) {
  Robot robot;
  for (int i = 0; i < 40; ++i) robot.frame(0.003 * i);  // 0.2 degrees a second
  EXPECT_EQ(robot.moving(), true);
}

/// Slower than 0.05 degrees in 0.3 s is at rest, however long it goes on.
TEST(Standstill, doesNotComeAndGoInASlowDrift) {
  Robot robot;
  for (int i = 0; i < 21; ++i) robot.frame(0.002 * i);
  for (int i = 21; i < 200; ++i) {
    robot.frame(0.002 * i);
    ASSERT_EQ(robot.moving(), false) << i;
  }
}

TEST(Standstill, isUnknownWithoutAStreamOrWithoutJoints) {
  Robot robot;
  robot.frame(0, 0.0);
  robot.standstill.forget();
  EXPECT_EQ(robot.moving(), std::nullopt);
  robot.frame(0, 0.0);
  robot.standstill.see(link::RobotStatus{});
  EXPECT_EQ(robot.moving(), std::nullopt);
}

}  // namespace
}  // namespace cobot_command::robot
