// PLines in a row, PVT, and velocities that a script sets.
#include <cmath>

#include "simulated_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/common/units.h"

namespace cobot_command::simulator::test {
namespace {

const std::string kEnd = "\r\n";

class ModesTest : public ::testing::Test {
 protected:
  void expectSmooth(Duration duration) {
    constexpr double kStep = 1e-3;
    constexpr double kLargestAcceleration = 30.0;  // [rad/s^2]
    RobotState before = robot.state();
    for (Duration t{}; t < duration; t += 1ms) {
      robot.wait(1ms);
      const RobotState after = robot.state();
      const arm::JointVector predicted = before.joints + 0.5 * kStep * (before.velocities + after.velocities);
      ASSERT_LT((after.joints - predicted).cwiseAbs().maxCoeff(), kLargestAcceleration * kStep * kStep);
      ASSERT_LT((after.velocities - before.velocities).cwiseAbs().maxCoeff(), kLargestAcceleration * kStep);
      before = after;
    }
  }
  void run(const std::string& id, const std::string& lines) { robot.script(client, id, lines); }
  [[nodiscard]] double seconds() const { return toSeconds(robot.now() - Instant{}); }
  /// Of the TCP [mm].
  [[nodiscard]] Eigen::Vector3d travelled() const {
    return 1e3 * (robot.state().flange.translation() - start);
  }
  [[nodiscard]] double speedOf(int joint) const { return radToDeg(robot.state().velocities[joint - 1]); }

  static Settings licensed() {
    Settings settings;
    settings.velocity_licence = true;
    return settings;
  }

  SimulatedRobot robot{licensed()};
  ClientId client = robot.connect();
  Eigen::Vector3d start = robot.state().flange.translation();
};

// --- PLine -------------------------------------------------------------------------------------------------

TEST_F(ModesTest, plinesPassClosePointsAtOneSpeed) {
  std::string lines;
  for (int i = 0; i < 15; ++i) lines += "Move_PLine(\"CAP\",-10,0,0,0,0,0,100,100,50)" + kEnd;
  run("1", lines + "QueueTag(1)");
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.wait(150ms);
  for (int i = 0; i < 25; ++i) {
    const Eigen::Vector3d before = travelled();
    robot.wait(50ms);
    EXPECT_NEAR((travelled() - before).norm(), 5.0, 1e-4) << "100 mm/s";
  }
  robot.waitUntilIdle();
  EXPECT_NEAR(seconds(), 1.5 + 0.1, 1e-6);
  EXPECT_NEAR(travelled().x(), -150, 1e-6);
  EXPECT_EQ(robot.heard(client), tag("01,true"));
}

TEST_F(ModesTest, plinesTakeOverFromOneWhoseScriptCameBefore) {
  run("1", "Move_PLine(\"CAP\",-80,0,0,0,0,0,100,100,50)");
  robot.wait(400ms);
  run("2", "Move_PLine(\"CAP\",0,0,-80,0,0,0,100,100,50)");
  expectSmooth(1200ms);
  robot.waitUntilIdle();
  EXPECT_NEAR(seconds(), 1.6 + 0.1, 1e-6);
  EXPECT_LT((travelled() - Eigen::Vector3d(-80, 0, -80)).norm(), 1e-6);
}

TEST_F(ModesTest, plinesArePausedAndStoppedOnTheirWay) {
  run("1",
      "Move_PLine(\"CAP\",-80,0,0,0,0,0,100,100,50)" + kEnd + "Move_PLine(\"CAP\",0,0,-80,0,0,0,100,100,50)");
  robot.wait(700ms);
  run("2", "Pause()");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
  run("3", "Resume()");
  expectSmooth(500ms);
  run("4", "StopAndClearBuffer()");
  expectSmooth(300ms);
  EXPECT_EQ(robot.state().queued_motions, 0);
}

TEST_F(ModesTest, plinesBlendWithOtherMotions) {
  run("1", "Move_Line(\"CAP\",-60,0,0,0,0,0,100,200,100,false)" + kEnd +
               "Move_PLine(\"CAP\",0,0,-60,0,0,0,100,200,100)" + kEnd +
               "Move_PLine(\"TAP\",0,0,-60,0,0,0,100,200,100)" + kEnd +
               "Move_PTP(\"JPP\",10,0,0,0,0,0,20,200,0,false)");
  expectSmooth(2500ms);
  robot.waitUntilIdle();
  const Eigen::Vector3d flange = robot.state().flange.translation();
  EXPECT_NEAR(flange.z(), start.z(), 1e-9) << "down, and up again";
  EXPECT_NEAR(flange.head<2>().norm(), (start + Eigen::Vector3d(-0.06, 0, 0)).head<2>().norm(), 1e-9);
}

TEST_F(ModesTest, aPlineThatCannotBeMadeIsARobotError) {
  run("1", "PLine(\"CAP\",2000,0,0,180,0,90,100,100,0)" + kEnd + "QueueTag(1)");
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,false"));
  EXPECT_EQ(robot.state().error_code, 0x01);
}

// --- PVT ---------------------------------------------------------------------------------------------------

const std::string kPvt = "PVTEnter(0)" + kEnd + "PVTPoint(5,0,90,0,90,0,10,0,0,0,0,0,0.5)" + kEnd +
                         "QueueTag(2)" + kEnd + "IO[\"ControlBox\"].DO[3]=1" + kEnd +
                         "PVTPoint(10,0,90,0,90,0,0,0,0,0,0,0,1)" + kEnd + "PVTExit()";

TEST_F(ModesTest, pvtIsWhereItShallBeAtItsTimes) {
  run("1", kPvt + kEnd + "QueueTag(3)");
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.wait(499ms);
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_EQ(robot.state().outputs.control_box[3], false);
  robot.wait(1ms);
  EXPECT_EQ(robot.heard(client), tag("02,true"));
  EXPECT_EQ(robot.state().outputs.control_box[3], true);
  EXPECT_NEAR(robot.joints()[0], 5, 1e-6);
  EXPECT_NEAR(speedOf(1), 10, 1e-4);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.now() - Instant{}, 1500ms);
  EXPECT_EQ(robot.heard(client), tag("03,true"));
  EXPECT_NEAR(robot.joints()[0], 10, 1e-9);
}

TEST_F(ModesTest, pvtTakesItsTagsAlongAtALowerProjectSpeed) {
  robot.operate(SetProjectSpeed{50});
  run("1", kPvt);
  robot.heard(client);
  robot.wait(999ms);
  EXPECT_EQ(robot.heard(client), "");
  robot.wait(1ms);
  EXPECT_EQ(robot.heard(client), tag("02,true"));
  robot.waitUntilIdle();
  EXPECT_EQ(robot.now() - Instant{}, 3s);
}

TEST_F(ModesTest, pvtCanComeInSeveralScriptsAndStartsWithItsExit) {
  run("1", "PVTEnter()" + kEnd + "PVTPoint(5,0,90,0,90,0,0,0,0,0,0,0,1)");
  robot.wait(1s);
  EXPECT_FALSE(robot.state().in_motion);
  run("2", "PVTPoint({0,0,90,0,90,0},{0,0,0,0,0,0},1)" + kEnd + "PVTExit()");
  EXPECT_TRUE(robot.state().queued_motions == 1);
  robot.waitUntilIdle();
  EXPECT_NEAR(seconds(), 3.0, 1e-8);
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2"));
}

TEST_F(ModesTest, pvtOfPosesMovesTheTcp) {
  run("1",
      "PVTEnter(1)" + kEnd + "PVTPoint(367.5,-122.3,361.05,180,0,90,0,0,0,0,0,0,2)" + kEnd + "PVTExit()");
  robot.wait(1s);
  EXPECT_NEAR(travelled().x(), -25, 1e-6);
  robot.waitUntilIdle();
  EXPECT_LT((travelled() - Eigen::Vector3d(-50, 0, 0)).norm(), 1e-6);
}

TEST_F(ModesTest, pvtIsRefusedAsAWholeBeforeItStarts) {
  run("1", "PVTEnter(0)" + kEnd + "PVTPoint(5,0,90,0,90,0,0,0,0,0,0,0,1)" + kEnd + "QueueTag(1)" + kEnd +
               "PVTPoint(200,0,90,0,90,0,0,0,0,0,0,0,0.1)" + kEnd + "PVTExit()" + kEnd + "QueueTag(2)");
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,false") + tag("02,false"));
  EXPECT_EQ(robot.state().error_code, 0x21);
  EXPECT_NEAR(robot.joints()[0], 0, 1e-9);
}

TEST_F(ModesTest, pvtPauseHoldsAPvtAndNothingElse) {
  run("1", "PVTEnter(0)" + kEnd + "PVTPoint(30,0,90,0,90,0,0,0,0,0,0,0,10)" + kEnd + "PVTExit()" + kEnd +
               "Move_PTP(\"JPP\",10,0,0,0,0,0,20,200,0,false)");
  robot.wait(5s);
  run("2", "PVTPause()");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_FALSE(robot.state().project_paused);
  run("3", "Resume()");
  robot.wait(1s);
  EXPECT_FALSE(robot.state().in_motion) << "the project was not paused";
  run("4", "PVTResume()");
  expectSmooth(300ms);
  EXPECT_TRUE(robot.state().in_motion);
  robot.wait(5s);
  run("5", "PVTPause()");
  EXPECT_TRUE(robot.state().in_motion) << "a PTP by now";
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 40, 1e-9);
}

TEST_F(ModesTest, aStopEndsAPvtWithItsTags) {
  run("1", kPvt);
  robot.wait(300ms);
  run("2", "StopAndClearBuffer()");
  expectSmooth(300ms);
  robot.wait(2s);
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2"));
  EXPECT_EQ(robot.ask(client, "01,02"), tag("02,none"));
  EXPECT_EQ(robot.state().outputs.control_box[3], false);
}

TEST_F(ModesTest, aStopDropsAnOpenPvt) {
  run("1", "PVTEnter(0)" + kEnd + "PVTPoint(5,0,90,0,90,0,0,0,0,0,0,0,1)" + kEnd + "QueueTag(1)");
  run("2", "StopAndClearBuffer()");
  run("3", "PVTExit()");
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2") + error("3", "1"));
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,none"));
}

TEST_F(ModesTest, whatCannotStandWithinOrWithoutAPvtFailsItsLine) {
  run("1", "PVTPoint(5,0,90,0,90,0,0,0,0,0,0,0,1)");
  run("2", "PVTExit()");
  EXPECT_EQ(robot.heard(client), error("1", "1") + error("2", "1"));
  run("3", "PVTEnter(0)");
  for (const std::string line :
       {"PVTEnter(1)", "QueueTag(1,1)", "PTP(\"JPP\",0,0,90,0,90,0,10,200,0,false)", "ContinueVJog()"}) {
    robot.heard(client);
    run("4", line);
    EXPECT_EQ(robot.heard(client), error("4", "1")) << line;
  }
  run("5", "PVTEnter(2)");
  EXPECT_EQ(robot.heard(client), error("5", "1"));
}

TEST_F(ModesTest, aPvtThatIsLeftOpenEndsWithTheNode) {
  run("1", "PVTEnter(0)" + kEnd + "ScriptExit()");
  robot.wait(200ms);
  EXPECT_TRUE(robot.state().listening);
  robot.heard(client);
  run("2", "PVTExit()");
  EXPECT_EQ(robot.heard(client), error("2", "1"));
}

// --- Velocities --------------------------------------------------------------------------------------------

TEST_F(ModesTest, velocitiesNeedALicence) {
  SimulatedRobot other;
  const ClientId stranger = other.connect();
  for (const std::string line :
       {"ContinueVJog()", "ContinueVLine(500,500)", "SetContinueVJog(1,0,0,0,0,0)",
        "SetContinueVLine(10,0,0,0,0,0)", "StopContinueVmode()", "SuspendContinueVmode()"}) {
    other.script(stranger, "1", line);
    EXPECT_EQ(other.heard(stranger), error("1", "1")) << line;
  }
}

TEST_F(ModesTest, jointVelocitiesGrowEvenlyAndStay) {
  run("1", "ContinueVJog()" + kEnd + "SetContinueVJog(10,0,0,0,0,-20)");
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.wait(100ms);
  EXPECT_NEAR(speedOf(1), 5, 1e-6);
  robot.wait(100ms);
  EXPECT_NEAR(speedOf(1), 10, 1e-6);
  robot.wait(1s);
  EXPECT_NEAR(speedOf(6), -20, 1e-6);
  EXPECT_NEAR(robot.joints()[0], 11, 1e-6);
  run("2", "SetContinueVJog(-10,0,0,0,0,0)");
  expectSmooth(500ms);
  EXPECT_NEAR(speedOf(1), -10, 1e-6);
  run("3", "StopContinueVmode()");
  expectSmooth(250ms);
  EXPECT_FALSE(robot.state().in_motion);
  run("4", "SetContinueVJog(1,0,0,0,0,0)");
  EXPECT_EQ(robot.heard(client), ok("2") + ok("3") + error("4", "1")) << "the mode is over";
}

TEST_F(ModesTest, velocitiesWaitForTheMotionsBeforeThemAndHoldThoseBehind) {
  run("1", "PVTEnter(0)" + kEnd + "PVTPoint(5,0,90,0,90,0,0,0,0,0,0,0,1)" + kEnd + "PVTExit()" + kEnd +
               "ContinueVJog()" + kEnd + "SetContinueVJog(10,0,0,0,0,0)" + kEnd + "QueueTag(1)");
  robot.wait(1s);
  EXPECT_NEAR(robot.joints()[0], 5, 1e-6);
  robot.wait(200ms);
  EXPECT_NEAR(speedOf(1), 10, 1e-6);
  robot.heard(client);
  run("2", "StopContinueVmode()");
  EXPECT_EQ(robot.heard(client), ok("2"));
  robot.wait(300ms);
  EXPECT_EQ(robot.heard(client), tag("01,true"));
}

TEST_F(ModesTest, velocitiesOfTheTcpEndWithoutNewOnes) {
  run("1", "ContinueVLine(500,1000)");
  run("2", "SetContinueVLine(0,50,0,0,0,0)");
  robot.wait(400ms);
  run("3", "SetContinueVLine(0,50,0,0,0,0)");
  expectSmooth(500ms);
  EXPECT_TRUE(robot.state().in_motion);
  expectSmooth(250ms);
  EXPECT_FALSE(robot.state().in_motion) << "500 ms, and 200 ms to rest";
  EXPECT_NEAR(travelled().y(), 50 * (0.4 + 0.5), 1e-6);
  run("4", "SetContinueVLine(0,0,-50,0,0,0)");
  robot.wait(2s);
  run("5", "SetContinueVLine(0,0,-50,0,0,0)");
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2") + ok("3") + ok("4") + error("5", "1"))
      << "1000 ms ended the mode";
}

TEST_F(ModesTest, velocitiesOfTheTcpAreAlongTheAxesOfTheBase) {
  run("1",
      "ChangeBase(0,0,0,0,0,90)" + kEnd + "ContinueVLine(0,0)" + kEnd + "SetContinueVLine(50,0,0,0,0,10)");
  robot.wait(1100ms);
  EXPECT_NEAR(travelled().y(), 50, 1e-4);
  EXPECT_NEAR(robot.tool()[5], 10, 1e-4) << "0 at the start";
}

TEST_F(ModesTest, aSuspendedModeTakesTheNextVelocity) {
  run("1", "ContinueVJog()" + kEnd + "SetContinueVJog(10,0,0,0,0,0)");
  robot.wait(500ms);
  run("2", "SuspendContinueVmode()");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
  run("3", "SetContinueVJog(0,0,10,0,0,0)");
  expectSmooth(300ms);
  EXPECT_NEAR(speedOf(3), 10, 1e-6);
  run("4", "SetContinueVJog(0,0,0,0,0,0)");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
}

TEST_F(ModesTest, aVelocityThatComesToALimitIsARobotErrorAtRest) {
  run("1", "ContinueVJog()" + kEnd + "SetContinueVJog(0,0,20,0,0,0)" + kEnd + "QueueTag(1)");
  robot.wait(10s);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_EQ(robot.state().error_code, 0x1405A);
  EXPECT_NEAR(robot.joints()[2], 155, 1e-6);
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,false"));
}

TEST_F(ModesTest, aVelocityThatCannotBeTakenStopsTheArm) {
  run("1", "ContinueVJog()" + kEnd + "SetContinueVJog(10,0,0,0,0,0)");
  robot.wait(500ms);
  run("2", "SetContinueVJog(1000,0,0,0,0,0)");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_EQ(robot.state().error_code, 0x21);
}

TEST_F(ModesTest, aPauseHoldsTheVelocityAndAStopEndsIt) {
  run("1", "ContinueVJog()" + kEnd + "SetContinueVJog(10,0,0,0,0,0)");
  robot.wait(500ms);
  run("2", "Pause()");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
  robot.heard(client);
  run("3", "SetContinueVJog(20,0,0,0,0,0)");
  EXPECT_EQ(robot.heard(client), error("3", "1"));
  run("4", "Resume()");
  expectSmooth(300ms);
  EXPECT_NEAR(speedOf(1), 10, 1e-6);
  run("5", "StopAndClearBuffer()");
  expectSmooth(300ms);
  EXPECT_FALSE(robot.state().in_motion);
  run("6", "Move_PTP(\"JPP\",10,0,0,0,0,0,20,200,0,false)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.state().error_code, 0);
}

TEST_F(ModesTest, leavingTheNodeEndsVelocities) {
  run("1", "ContinueVJog()" + kEnd + "SetContinueVJog(10,0,0,0,0,0)");
  robot.wait(500ms);
  run("2", "ScriptExit()");
  robot.wait(400ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_TRUE(robot.state().listening) << "again";
}

}  // namespace
}  // namespace cobot_command::simulator::test
