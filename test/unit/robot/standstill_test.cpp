// Whether a robot stands, by its joint speeds, or by its joint angles where there are no speeds.

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

TEST(Standstill, isToldByTheJointSpeeds) {
  Robot robot;
  EXPECT_EQ(robot.moving(), std::nullopt);
  robot.frame(0, 0.2);
  EXPECT_EQ(robot.moving(), true);
  robot.frame(10, -0.05);
  EXPECT_EQ(robot.moving(), false) << "whatever the angles are";
}

TEST(Standstill, isToldByTheJointAnglesWhereThereAreNoSpeeds) {
  Robot robot;
  robot.frame(0);
  EXPECT_EQ(robot.moving(), std::nullopt) << "of one frame nobody can say";
  robot.frame(0.1);
  EXPECT_EQ(robot.moving(), true);
  for (int i = 0; i < 6; ++i) robot.frame(0.1);
  EXPECT_EQ(robot.moving(), true) << "90 ms";
  robot.frame(0.1);
  EXPECT_EQ(robot.moving(), false);
  robot.frame(0.12);
  EXPECT_EQ(robot.moving(), true);
}

TEST(Standstill, isNotTakenFromTwoFramesThatTheNetworkHeldBack) {
  Robot robot;
  robot.frame(0);
  robot.frame(0.1);
  robot.frame(0.105, std::nullopt, 500ms);
  EXPECT_EQ(robot.moving(), true);
  robot.frame(0.12, std::nullopt, 0ms);
  EXPECT_EQ(robot.moving(), true);
}

TEST(Standstill, seesASlowMotionThatHardlyChangesFromFrameToFrame) {
  Robot robot;
  for (int i = 0; i < 40; ++i) robot.frame(0.002 * i);  // 0.13 degrees a second
  EXPECT_EQ(robot.moving(), true);
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
