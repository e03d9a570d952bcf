// A robot that follows a PVT straight from point to point, or late, as its clients see it.
#include <cmath>

#include "faults_fixture.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

/// Joint 1 by 10 degrees in 1 s and on by 10 in another; in the middle its speed is 15 deg/s.
const std::string kPvt =
    "PVTEnter(0)\r\nPVTPoint(10,0,90,0,90,0,15,0,0,0,0,0,1)\r\nQueueTag(2)\r\n"
    "PVTPoint(20,0,90,0,90,0,0,0,0,0,0,0,1)\r\nPVTExit()\r\nQueueTag(3)";
/// The cubic of the first second, from rest [deg].
double onCubic(double t) {
  return t * t * (10 * (3 - 2 * t) + 15 * (t - 1));
}

class PvtDeviation : public FaultsTest {
 protected:
  [[nodiscard]] double joint() const { return robot.joints()[0]; }
  [[nodiscard]] double seconds() const { return toSeconds(robot.now() - Instant{}); }
};

TEST_F(PvtDeviation, goesStraightBetweenThePointsWithTheFault) {
  fault("pvt_linear");
  robot.script(client, "1", kPvt);
  robot.wait(250ms);
  EXPECT_NEAR(joint(), 2.5, 1e-9);
  EXPECT_GT(std::abs(joint() - onCubic(0.25)), 1) << "that is not the cubic";
  robot.wait(750ms);
  EXPECT_NEAR(joint(), 10, 1e-9);
  EXPECT_EQ(robot.heard(client), ok("1") + tag("02,true"));
  robot.waitUntilIdle();
  EXPECT_NEAR(joint(), 20, 1e-9);
  EXPECT_NEAR(seconds(), 2, 1e-8);
  EXPECT_EQ(robot.heard(client), tag("03,true"));
}

TEST_F(PvtDeviation, goesStraightAtALowerProjectSpeedToo) {
  fault("pvt_linear");
  robot.operate(SetProjectSpeed{50});
  robot.script(client, "1", kPvt);
  robot.wait(500ms);
  EXPECT_NEAR(joint(), 2.5, 1e-9);
  robot.wait(1500ms);
  EXPECT_NEAR(joint(), 10, 1e-9);
}

TEST_F(PvtDeviation, takesTheFaultForPvtThatBeginWhileItIsOn) {
  robot.script(client, "1", kPvt);
  robot.wait(100ms);
  fault("pvt_linear");
  robot.wait(150ms);
  EXPECT_NEAR(joint(), onCubic(0.25), 1e-9);
  off("pvt_linear");
  robot.waitUntilIdle();
  robot.script(client, "2", "PVTEnter(0)\r\nPVTPoint(0,0,90,0,90,0,0,0,0,0,0,0,2)\r\nPVTExit()");
  robot.wait(500ms);
  EXPECT_NEAR(joint(), 20 - 20 * 0.25 * 0.25 * 2.5, 1e-9);
}

TEST_F(PvtDeviation, goesStraightInItsJointsBetweenPosesAsWell) {
  fault("pvt_linear");
  robot.script(client, "1",
               "PVTEnter(1)\r\nPVTPoint(367.5,-122.3,361.05,180,0,90,0,0,0,0,0,0,2)\r\nPVTExit()");
  const arm::ControllerJoints start = robot.joints();
  robot.wait(1s);
  const arm::ControllerJoints middle = robot.joints();
  EXPECT_GT(std::abs(robot.tool()[2] - 361.05), 0.1) << "off the line";
  robot.waitUntilIdle();
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(middle[i], (start[i] + robot.joints()[i]) / 2, 1e-9);
  }
  EXPECT_NEAR(robot.tool()[0], 367.5, 1e-6);
}

TEST_F(PvtDeviation, tellsThatTheFaultCannotBeCounted) {
  EXPECT_THAT(refusal(SetFault{"pvt_linear", true, 2, 0, ""}), ::testing::HasSubstr("cannot be counted"));
}

class LatePvt : public PvtDeviation {
 protected:
  LatePvt() {
    Settings settings;
    settings.pvt_lag = 50ms;
    robot = SimulatedRobot(settings);
    client = robot.connect();
  }
};

TEST_F(LatePvt, lagsBehindAndComesToTheSameEndWithItsTags) {
  robot.script(client, "1", kPvt);
  robot.wait(300ms);
  EXPECT_NEAR(joint(), onCubic(0.25), 1e-9);
  robot.wait(749ms);
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.wait(1ms);
  EXPECT_NEAR(joint(), 10, 1e-6);
  EXPECT_EQ(robot.heard(client), tag("02,true")) << "where the arm is at its point";
  robot.waitUntilIdle();
  EXPECT_NEAR(seconds(), 2.05, 1e-8);
  EXPECT_NEAR(joint(), 20, 1e-12);
  EXPECT_EQ(robot.heard(client), tag("03,true"));
}

TEST_F(LatePvt, isOnTimeWithAllOtherMotions) {
  robot.script(client, "1", "PTP(\"JPP\",90,0,90,0,90,0,100,200,0,false)");
  robot.waitUntilIdle();
  EXPECT_NEAR(seconds(), 0.7, 1e-3);
}

TEST_F(LatePvt, standsWithinTheStopTimeWhenItIsStopped) {
  robot.script(client, "1", kPvt);
  robot.wait(500ms);
  robot.script(client, "2", "StopAndClearBuffer()");
  robot.wait(200ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_NEAR(joint(), onCubic(0.55), 1e-6);
}

}  // namespace
}  // namespace cobot_command::simulator::test
