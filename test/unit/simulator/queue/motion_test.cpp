// Motions of the script language: where the arm ends, and through where it goes.
#include <array>
#include <cmath>

#include "simulated_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/pose_bits.h"

namespace cobot_command::simulator::test {
namespace {

using arm::ControllerPose;

class MotionTest : public ::testing::Test {
 protected:
  void run(const std::string& script) {
    robot.script(client, "1", script + "\r\nQueueTag(1)");
    robot.waitUntilIdle();
    EXPECT_EQ(robot.heard(client), ok("1") + tag("01,true")) << robot.state().error_text;
  }
  static void expectPose(const ControllerPose& pose, const ControllerPose& expected) {
    EXPECT_TRUE(arm::toPose(pose).isApprox(arm::toPose(expected), 1e-9))
        << ::testing::PrintToString(pose) << " is not " << ::testing::PrintToString(expected);
  }
  // The start: joints 0, 0, 90, 0, 90, 0.
  static constexpr ControllerPose kStart{417.5, -122.3, 361.05, 180, 0, 90};

  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(MotionTest, startsInTheDocumentedPosture) {
  expectPose(robot.tool(), kStart);
}

TEST_F(MotionTest, ptpGoesToJoints) {
  run("PTP(\"JPP\",30,-20,100,10,80,-45,50,200,0,false)");
  const arm::ControllerJoints wanted{30, -20, 100, 10, 80, -45};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(robot.joints()[i], wanted[i], 1e-9);
}

TEST_F(MotionTest, ptpGoesToAPoseAndKeepsThePoseBits) {
  run("PTP(\"CPP\",350,-50,400,180,0,90,50,200,0,false)");
  expectPose(robot.tool(), {350, -50, 400, 180, 0, 90});
  EXPECT_EQ(arm::poseBitsOf(robot.controller().arm(), robot.state().joints).numbers(),
            (std::array<int, 3>{0, 2, 4}));
}

TEST_F(MotionTest, ptpGoesToAPoseWithTheWantedPoseBits) {
  run("PTP(\"CPP\",417.5,-122.3,361.05,180,0,90,50,200,0,false,0,3,4)");
  expectPose(robot.tool(), kStart);
  EXPECT_NEAR(robot.joints()[1], 86.8699, 1e-3);
}

TEST_F(MotionTest, lineGoesStraight) {
  robot.script(client, "1", "Line(\"CAP\",417.5,77.7,461.05,180,0,90,100,200,0,false)");
  while (robot.state().in_motion) {
    robot.wait(20ms);
    const ControllerPose pose = robot.tool();
    EXPECT_NEAR(pose[0], 417.5, 1e-6);
    EXPECT_NEAR((pose[1] + 122.3) / 2.0, pose[2] - 361.05, 1e-6);
  }
  expectPose(robot.tool(), {417.5, 77.7, 461.05, 180, 0, 90});
}

TEST_F(MotionTest, circleGoesThroughViaToTheEnd) {
  robot.script(client, "1",
               "Circle(\"CAP\",467.5,-72.3,361.05,180,0,90,417.5,-22.3,361.05,180,0,90,100,200,0,0,false)");
  while (robot.state().in_motion) {
    robot.wait(20ms);
    const ControllerPose pose = robot.tool();
    EXPECT_NEAR(std::hypot(pose[0] - 417.5, pose[1] + 72.3), 50.0, 1e-6);
    EXPECT_GE(pose[0], 417.5 - 1e-6);
  }
  expectPose(robot.tool(), {417.5, -22.3, 361.05, 180, 0, 90});
}

TEST_F(MotionTest, circleWithAnAngleGoesThatFar) {
  run("Circle(\"CAP\",467.5,-72.3,361.05,180,0,90,417.5,-22.3,361.05,180,0,90,100,200,0,270,false)");
  expectPose(robot.tool(), {367.5, -72.3, 361.05, 180, 0, 90});
}

TEST_F(MotionTest, relativeInTheBaseShiftsAlongAndTurnsAboutTheBaseAxes) {
  run("Move_PTP(\"CPP\",10,20,30,0,0,15,50,200,0,false)");
  expectPose(robot.tool(), {427.5, -102.3, 391.05, 180, 0, 105});
  run("Move_Line(\"CAP\",-10,-20,-30,0,0,-15,50,200,0,false)");
  expectPose(robot.tool(), kStart);
}

TEST_F(MotionTest, relativeInTheToolShiftsAndTurnsInTheToolFrame) {
  // The tool looks down: its z is the base's -z; its x is the base's y.
  run("Move_Line(\"TAP\",10,0,20,0,0,15,50,200,0,false)");
  expectPose(robot.tool(), {417.5, -112.3, 341.05, 180, 0, 75});
  run("Move_PTP(\"TPP\",0,0,-20,0,0,0,50,200,0,false)");
  expectPose(robot.tool(), {417.5, -112.3, 361.05, 180, 0, 75});
}

TEST_F(MotionTest, relativeInJointsAddsToTheJoints) {
  run("Move_PTP(\"JPP\",1,2,3,4,5,6,50,200,0,false)");
  const arm::ControllerJoints wanted{1, 2, 93, 4, 95, 6};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(robot.joints()[i], wanted[i], 1e-9);
}

TEST_F(MotionTest, relativeCountsFromWhereTheMotionBeforeEnds) {
  run("Move_Line(\"CAP\",10,0,0,0,0,0,50,200,0,false)\r\nMove_Line(\"CAP\",10,0,0,0,0,0,50,200,0,false)");
  expectPose(robot.tool(), {437.5, -122.3, 361.05, 180, 0, 90});
}

TEST_F(MotionTest, baseAndToolCountForTheMotionsBehindThemOnly) {
  robot.script(client, "1",
               "Line(\"CAP\",417.5,-22.3,361.05,180,0,90,100,200,0,false)\r\n"
               "ChangeBase(100,0,0,0,0,0)\r\nChangeTCP(0,0,50,0,0,0,1.5)\r\nChangeLoad(2.5)\r\n"
               "Line(\"CAP\",300,-22.3,311.05,180,0,90,100,200,0,false)");
  robot.wait(500ms);
  EXPECT_EQ(robot.state().base_name, "RobotBase");
  EXPECT_EQ(robot.state().tcp_name, "NOTOOL");
  robot.waitUntilIdle();
  expectPose(robot.tool(), {300, -22.3, 311.05, 180, 0, 90});
  const RobotState state = robot.state();
  expectPose(arm::toControllerPose(state.flange), {400, -22.3, 361.05, 180, 0, 90});
  EXPECT_EQ(state.base_name, "");
  EXPECT_EQ(state.tcp_name, "");
  EXPECT_EQ(state.tcp_mass, 1.5);
  EXPECT_EQ(state.load, 2.5);
}

TEST_F(MotionTest, baseAndToolGoByNameToo) {
  Settings settings;
  settings.bases["Table"] = arm::toPose({100, 0, 0, 0, 0, 0});
  settings.tcps["Gripper"] = arm::toPose({0, 0, 50, 0, 0, 0});
  SimulatedRobot equipped(settings);
  const ClientId one = equipped.connect();
  equipped.script(one, "1", "ChangeBase(\"Table\")\r\nChangeTCP(\"Gripper\")");
  EXPECT_EQ(equipped.state().base_name, "Table");
  EXPECT_EQ(equipped.state().tcp_name, "Gripper");
  expectPose(equipped.tool(), {317.5, -122.3, 311.05, 180, 0, 90});
  equipped.script(one, "2", "ChangeBase(\"RobotBase\")\r\nChangeTCP(\"NOTOOL\")");
  expectPose(equipped.tool(), kStart);
}

TEST_F(MotionTest, theProjectSpeedScalesTheSpeedOfMotions) {
  Settings settings;
  settings.project_speed_percent = 50;
  SimulatedRobot slow(settings);
  const std::string move = "PTP(\"JPP\",90,0,90,0,90,0,100,200,0,false)";
  robot.script(client, "1", move);
  slow.script(slow.connect(), "1", move);
  robot.waitUntilIdle();
  slow.waitUntilIdle();
  EXPECT_EQ(slow.state().project_speed_percent, 50);
  // 90 degrees at 180 deg/s and at half of it, each with its time to top speed.
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 0.5 + 0.2, 1e-6);
  EXPECT_NEAR(toSeconds(slow.now() - Instant{}), 1.0 + 0.2, 1e-6);
}

TEST_F(MotionTest, countsTheMotionsThatAreNotDone) {
  robot.script(
      client, "1",
      "Move_PTP(\"JPP\",1,0,0,0,0,0,50,200,0,false)\r\nMove_PTP(\"JPP\",1,0,0,0,0,0,50,200,0,false)");
  EXPECT_EQ(robot.state().queued_motions, 2);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.state().queued_motions, 0);
}

TEST_F(MotionTest, aMotionToWhereTheArmStandsIsDoneAtOnce) {
  robot.script(client, "1", "PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)\r\nQueueTag(1)");
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,true"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
