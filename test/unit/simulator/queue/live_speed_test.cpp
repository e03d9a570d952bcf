// A project speed that counts for the motion that is under way.
#include <cmath>

#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

const std::string kMove = "PTP(\"JPP\",90,0,90,0,90,0,100,200,0,false)";
const std::string kBack = "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)";

Settings live() {
  Settings settings;
  settings.project_speed_live = true;
  return settings;
}

class LiveSpeed : public ::testing::Test {
 protected:
  void run(const std::string& script) { robot.script(client, "1", script); }
  void speed(int percent) { robot.operate(SetProjectSpeed{percent}); }
  [[nodiscard]] double joint() const { return robot.joints()[0]; }
  [[nodiscard]] double velocity() const { return radToDeg(robot.state().velocities[0]); }
  /// Until it stands, from now on.
  double duration() {
    const Instant start = robot.now();
    robot.waitUntilIdle();
    return toSeconds(robot.now() - start);
  }

  SimulatedRobot robot{live()};
  ClientId client = robot.connect();
};

TEST_F(LiveSpeed, slowsTheMotionThatIsUnderWayWithoutAJump) {
  run(kMove);
  robot.wait(350ms);
  const double before = joint();
  EXPECT_NEAR(velocity(), 180, 1e-9);
  speed(50);
  EXPECT_EQ(joint(), before);
  EXPECT_NEAR(velocity(), 90, 1e-9);
  robot.wait(100ms);
  EXPECT_NEAR(joint() - before, 9, 1e-6);
  EXPECT_NEAR(duration(), 2 * 0.35 - 0.1, 1e-6);
  EXPECT_NEAR(joint(), 90, 1e-9);
}

TEST_F(LiveSpeed, speedsItUpAgain) {
  speed(10);
  run(kMove);
  const double whole = 5.0 + 0.2;
  robot.wait(1s);
  speed(100);
  EXPECT_NEAR(duration(), (whole - 1) / 10, 1e-6);
  EXPECT_NEAR(joint(), 90, 1e-9);
}

TEST_F(LiveSpeed, plansTheNextMotionAsAnyOther) {
  run(kMove + "\r\n" + kBack);
  robot.wait(350ms);
  speed(50);
  EXPECT_NEAR(duration(), 2 * 0.35 + 1.0 + 0.2, 1e-3);
}

TEST_F(LiveSpeed, takesTheTagsOfAPvtAlong) {
  run("PVTEnter(0)\r\nPVTPoint(5,0,90,0,90,0,10,0,0,0,0,0,0.5)\r\nQueueTag(2)\r\n"
      "PVTPoint(10,0,90,0,90,0,0,0,0,0,0,0,1)\r\nPVTExit()");
  robot.heard(client);
  robot.wait(250ms);
  speed(25);
  robot.wait(999ms);
  EXPECT_EQ(robot.heard(client), "");
  robot.wait(1ms);
  EXPECT_EQ(robot.heard(client), tag("02,true"));
  EXPECT_NEAR(joint(), 5, 1e-6);
  EXPECT_NEAR(duration(), 4, 1e-6);
}

TEST_F(LiveSpeed, holdsAndReleasesWithinTheStopTimeAtAnySpeed) {
  run(kMove);
  robot.wait(300ms);
  run("Pause()");
  robot.wait(100ms);
  EXPECT_NEAR(velocity(), 90, 1e-6);
  const double before = joint();
  speed(20);
  EXPECT_EQ(joint(), before) << "in the middle of slowing down";
  EXPECT_NEAR(velocity(), 18, 1e-6);
  robot.wait(100ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_NEAR(joint() - before, 18 * 0.1 / 2, 1e-6);
  speed(50);
  robot.wait(1s);
  EXPECT_FALSE(robot.state().in_motion) << "a speed does not let it go on";
  run("Resume()");
  robot.wait(200ms);
  EXPECT_NEAR(velocity(), 90, 1e-6);
  robot.waitUntilIdle();
  EXPECT_NEAR(joint(), 90, 1e-9);
}

TEST_F(LiveSpeed, brakesWithinTheStopTimeWhenItChangesMeanwhile) {
  run(kMove);
  robot.wait(300ms);
  run("StopAndClearBuffer()");
  robot.wait(100ms);
  speed(50);
  robot.wait(100ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_LT(joint(), 80);
}

/// At one pace for both, so that nothing jumps where one passes into the other.
TEST_F(LiveSpeed, keepsItsPaceThroughABlend) {
  run("PTP(\"JPP\",90,0,90,0,90,0,100,200,100,false)");
  robot.wait(300ms);
  speed(50);
  run("PTP(\"JPP\",90,0,30,0,90,0,100,200,0,false)");
  RobotState before = robot.state();
  double fastest = 0;
  while (robot.controller().nextEvent() != Instant::max()) {
    robot.wait(1ms);
    const RobotState after = robot.state();
    fastest = std::max(fastest, (after.velocities - before.velocities).cwiseAbs().maxCoeff() / 1e-3);
    before = after;
  }
  EXPECT_LT(fastest, degToRad(180) / 0.2 / 4 * 1.1) << "half of the speed, a quarter of the acceleration";
  EXPECT_NEAR(robot.joints()[0], 90, 1e-9);
  EXPECT_NEAR(robot.joints()[2], 30, 1e-9);
  // 0.7 s and 0.533 s with 0.2 s of both; 0.3 s of them at full speed.
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 0.3 + (0.7 + 0.5333 - 0.2 - 0.3) * 2, 3e-3);
}

TEST_F(LiveSpeed, isAsItWasWhileNothingIsUnderWay) {
  speed(50);
  run(kMove);
  EXPECT_NEAR(duration(), 1.0 + 0.2, 1e-3);
}

TEST_F(LiveSpeed, leavesVelocitiesThatAreSetAsTheyAre) {
  Settings settings = live();
  settings.velocity_licence = true;
  robot = SimulatedRobot(settings);
  client = robot.connect();
  run("ContinueVJog()\r\nSetContinueVJog(10,0,0,0,0,0)");
  robot.wait(1s);
  speed(50);
  EXPECT_NEAR(velocity(), 10, 1e-6);
}

TEST(SpeedThatIsNotLive, countsFromTheNextMotionOn) {
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  robot.script(client, "1", kMove);
  robot.wait(350ms);
  robot.operate(SetProjectSpeed{50});
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 0.7, 1e-3);
}

}  // namespace
}  // namespace cobot_command::simulator::test
