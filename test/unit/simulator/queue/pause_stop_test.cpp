// Pause, Resume and StopAndClearBuffer: on the path, without a step in position or velocity.
#include <cmath>

#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

constexpr const char* kMove = "PTP(\"JPP\",90,20,60,0,90,0,100,200,0,false)\r\nQueueTag(1)";
constexpr const char* kNext = "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)\r\nQueueTag(2)";

class PauseStopTest : public ::testing::Test {
 protected:
  void moveFor(Duration duration) {
    robot.script(client, "1", kMove);
    robot.wait(duration);
    robot.heard(client);
  }
  /// Lets time go by in steps of 1 ms; the largest jump of position and velocity that the states do not
  /// explain.
  void expectSmooth(Duration duration) {
    constexpr double kStep = 1e-3;
    // Top speed 180 deg/s in 200 ms by the plan, and again by the ramp; some room for both at once.
    const double largest_acceleration = 3.0 * degToRad(180) / 0.2;
    RobotState before = robot.state();
    for (Duration t{}; t < duration; t += 1ms) {
      robot.wait(1ms);
      const RobotState after = robot.state();
      const arm::JointVector predicted = before.joints + 0.5 * kStep * (before.velocities + after.velocities);
      EXPECT_LT((after.joints - predicted).cwiseAbs().maxCoeff(), largest_acceleration * kStep * kStep);
      EXPECT_LT((after.velocities - before.velocities).cwiseAbs().maxCoeff(), largest_acceleration * kStep);
      before = after;
    }
  }

  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(PauseStopTest, pauseBringsTheArmToRestOnItsPath) {
  moveFor(300ms);
  robot.script(client, "2", "Pause()");
  EXPECT_EQ(robot.heard(client), ok("2"));
  EXPECT_TRUE(robot.state().project_paused);
  expectSmooth(250ms);
  const RobotState paused = robot.state();
  EXPECT_FALSE(paused.in_motion);
  EXPECT_TRUE(paused.velocities.isZero());
  EXPECT_EQ(paused.queued_motions, 1);
  robot.wait(1h);
  EXPECT_EQ(robot.state().joints, paused.joints);
}

TEST_F(PauseStopTest, resumeCompletesTheInterruptedMotion) {
  moveFor(300ms);
  robot.script(client, "2", "Pause()");
  robot.wait(1s);
  robot.script(client, "3", "Resume()");
  EXPECT_FALSE(robot.state().project_paused);
  expectSmooth(1s);
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  EXPECT_EQ(robot.heard(client), ok("2") + ok("3") + tag("01,true"));
}

TEST_F(PauseStopTest, resumeWhileItStillSlowsDownIsSmoothToo) {
  moveFor(300ms);
  robot.script(client, "2", "Pause()");
  expectSmooth(80ms);
  robot.script(client, "3", "Resume()");
  expectSmooth(800ms);
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
}

TEST_F(PauseStopTest, aMotionThatEndsWhileItSlowsDownIsComplete) {
  moveFor(690ms);  // of 700 ms
  robot.script(client, "2", std::string("Pause()\r\n") + kNext);
  expectSmooth(300ms);
  EXPECT_EQ(robot.heard(client), ok("2") + tag("01,true"));
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  robot.script(client, "3", "Resume()");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("3") + tag("02,true"));
}

TEST_F(PauseStopTest, pauseTwiceAndResumeWithoutAPauseChangeNothing) {
  robot.script(client, "1", "Resume()");
  EXPECT_EQ(robot.heard(client), ok("1"));
  moveFor(300ms);
  robot.script(client, "2", "Pause()");
  robot.wait(100ms);
  robot.script(client, "3", "Pause()");
  robot.wait(100ms);
  EXPECT_FALSE(robot.state().in_motion);
  robot.script(client, "4", "Resume()\r\nResume()");
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
}

TEST_F(PauseStopTest, scriptsGoOnWhilePausedAndTheirMotionsWait) {
  robot.script(client, "1", std::string("Pause()\r\n") + kMove);
  robot.wait(5s);
  EXPECT_EQ(robot.heard(client), ok("1"));
  EXPECT_EQ(robot.joints()[0], 0.0);
  EXPECT_EQ(robot.state().queued_motions, 1);
  robot.script(client, "2", "Resume()");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("2") + tag("01,true"));
}

TEST_F(PauseStopTest, stopBringsTheArmToRestAndDropsWhatIsQueued) {
  robot.script(client, "1", std::string(kMove) + "\r\n" + kNext);
  robot.wait(300ms);
  robot.heard(client);
  robot.script(client, "2", "StopAndClearBuffer()");
  EXPECT_EQ(robot.heard(client), ok("2"));
  expectSmooth(250ms);
  EXPECT_TRUE(robot.state().velocities.isZero());
  EXPECT_EQ(robot.state().queued_motions, 0);
  robot.wait(5s);
  EXPECT_LT(robot.joints()[0], 89.0);
  EXPECT_GT(robot.joints()[0], 20.0);
  EXPECT_EQ(robot.heard(client), "") << "tags of dropped motions are never reported";
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,none"));
  EXPECT_EQ(robot.ask(client, "01,02"), tag("02,none"));
}

TEST_F(PauseStopTest, aMotionBehindAStopStartsFromWhereTheArmStands) {
  moveFor(300ms);
  robot.script(client, "2", std::string("StopAndClearBuffer()\r\n") + kNext);
  expectSmooth(2s);
  EXPECT_NEAR(robot.joints()[0], 0.0, 1e-9);
  EXPECT_EQ(robot.heard(client), ok("2") + tag("02,true"));
}

TEST_F(PauseStopTest, stopWhilePausedDropsTheRestAndStaysPaused) {
  moveFor(300ms);
  robot.script(client, "2", "Pause()");
  robot.wait(1s);
  const double reached = robot.joints()[0];
  robot.script(client, "3", "StopAndClearBuffer()");
  EXPECT_TRUE(robot.state().project_paused);
  EXPECT_EQ(robot.state().queued_motions, 0);
  robot.script(client, "4", "Resume()");
  robot.wait(1s);
  EXPECT_EQ(robot.joints()[0], reached);
}

TEST_F(PauseStopTest, stopWaitsForItsTurnBehindAScriptThatWaits) {
  robot.script(client, "1", "PTP(\"JPP\",90,20,60,0,90,0,100,200,0,false)\r\nQueueTag(1,1)");
  robot.script(client, "2", "StopAndClearBuffer()");
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  EXPECT_EQ(robot.heard(client), tag("01,true") + ok("1") + ok("2"));
}

TEST_F(PauseStopTest, staleTagsComeWithTheNextMotionWhenTheFlagIsSet) {
  Settings settings;
  settings.faults.stale_tag.on = true;
  SimulatedRobot vendor(settings);
  const ClientId one = vendor.connect();
  vendor.script(one, "1", kMove);
  vendor.wait(300ms);
  vendor.script(one, "2", "StopAndClearBuffer()");
  vendor.wait(1s);
  EXPECT_EQ(vendor.heard(one), ok("1") + ok("2"));
  vendor.script(one, "3", kNext);
  vendor.waitUntilIdle();
  EXPECT_EQ(vendor.heard(one), ok("3") + tag("01,true") + tag("02,true"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
