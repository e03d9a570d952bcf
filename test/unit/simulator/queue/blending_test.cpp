// Motions that blend in the queue: when they take over, what else happens there, and what stops them.
#include <cmath>
#include <functional>

#include "simulated_robot.h"
#include <gtest/gtest.h>

#include "cobot_command/planning/script_planner.h"
#include "cobot_command/script/script_reader.h"

namespace cobot_command::simulator::test {
namespace {

// 80 mm at 100 mm/s with 200 ms to the top speed: 1 s. Blended by 100 % the next one takes over at 0.8 s.
const std::string kSideways = "Move_Line(\"CAP\",0,80,0,0,0,0,100,200,100,false)";
const std::string kDown = "Move_Line(\"CAP\",0,0,-80,0,0,0,100,200,0,false)";
const std::string kEnd = "\r\n";

class BlendingTest : public ::testing::Test {
 protected:
  /// Lets time go by in steps of 1 ms, and looks for a step in position or speed.
  void expectSmooth(Duration duration) {
    constexpr double kStep = 1e-3;
    constexpr double kLargestAcceleration = 20.0;  // [rad/s^2]
    RobotState before = robot.state();
    for (Duration t{}; t < duration; t += 1ms) {
      robot.wait(1ms);
      const RobotState after = robot.state();
      const arm::JointVector predicted = before.joints + 0.5 * kStep * (before.velocities + after.velocities);
      EXPECT_LT((after.joints - predicted).cwiseAbs().maxCoeff(), kLargestAcceleration * kStep * kStep);
      EXPECT_LT((after.velocities - before.velocities).cwiseAbs().maxCoeff(), kLargestAcceleration * kStep);
      before = after;
    }
  }
  /// Where the TCP is from where it was at the start [mm].
  [[nodiscard]] Eigen::Vector3d travelled() const {
    return 1e3 * (robot.state().flange.translation() - start);
  }
  void expectTravelled(double y, double z) const {
    EXPECT_NEAR(travelled().y(), y, 1e-6);
    EXPECT_NEAR(travelled().z(), z, 1e-6);
  }

  SimulatedRobot robot;
  ClientId client = robot.connect();
  Eigen::Vector3d start = robot.state().flange.translation();
};

TEST_F(BlendingTest, takesTheTimeAndThePathThatArePlanned) {
  const std::vector<std::string> lines = {"PTP(\"JPP\",20,-10,100,5,80,-30,80,250,70,false)",
                                          "Move_Line(\"CAR\",0,80,0,0,0,0,100,200,30,false)",
                                          "ChangeBase(10,20,30,0,0,0)",
                                          "Move_Line(\"TPR\",0,0,60,0,0,10,15,300,5,false)",
                                          "QueueTag(1)",
                                          "Move_PTP(\"JPP\",-10,5,-5,0,0,20,50,150,100,false)",
                                          "Move_PTP(\"CPP\",30,-30,30,0,0,0,20,200,50,true)",
                                          "ChangeTCP(0,0,100,0,0,0)",
                                          "Move_Line(\"CAP\",0,-60,0,0,0,0,100,200,40,false)",
                                          "Move_PTP(\"JPP\",0,0,0,0,0,0,50,200,100,false)",
                                          kDown};
  planning::ScriptPlanner planner(robot.controller().arm(), robot.state().joints, motion::Setting{});
  std::vector<planning::PlannedStep> steps;
  std::string script;
  for (const std::string& text : lines) {
    const auto step = planner.append(script::readScript(text)->front().command);
    ASSERT_TRUE(step) << text << ": " << step.error().message;
    if (step->trajectory) steps.push_back(*step);
    script += text + kEnd;
  }
  robot.script(client, "1", script);
  std::size_t next = 0;
  while (robot.state().queued_motions > 0) {
    const Duration time = robot.now() - Instant{};
    while (next + 1 < steps.size() && steps[next + 1].start <= time) ++next;
    const motion::JointState planned = steps[next].trajectory->at(time - steps[next].start);
    EXPECT_EQ(robot.state().joints, planned.position) << toSeconds(time);
    EXPECT_EQ(robot.state().velocities, planned.velocity) << toSeconds(time);
    robot.waitUntil(std::min(robot.now() + 3ms, robot.controller().nextEvent()));
  }
  EXPECT_EQ(robot.now() - Instant{}, planner.duration()) << "to a nanosecond";
  EXPECT_EQ(next, steps.size() - 1);
}

TEST_F(BlendingTest, isSmoothAndSavesTheTimeOfTheOverlap) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  expectSmooth(1790ms);
  EXPECT_TRUE(robot.state().in_motion);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 1.8, 1e-8);
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, settlesATagWhereTheNextMotionTakesOver) {
  robot.script(client, "1", kSideways + kEnd + "QueueTag(1)" + kEnd + kDown + kEnd + "QueueTag(2)");
  robot.heard(client);
  robot.wait(799ms);
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_EQ(robot.state().queued_motions, 2);
  robot.wait(2ms);
  EXPECT_EQ(robot.heard(client), tag("01,true"));
  EXPECT_EQ(robot.state().queued_motions, 1);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("02,true"));
}

TEST_F(BlendingTest, changesTheBaseAndWritesOutputsWhereTheNextMotionTakesOver) {
  robot.script(client, "1",
               kSideways + kEnd + "ChangeBase(100,0,0,0,0,0)" + kEnd + "ChangeLoad(2)" + kEnd +
                   "Line(\"CAP\",317.5,-42.3,281.05,180,0,90,100,200,0,false)");
  robot.wait(799ms);
  EXPECT_EQ(robot.state().base_name, "RobotBase");
  robot.wait(2ms);
  EXPECT_EQ(robot.state().base_name, "");
  EXPECT_EQ(robot.state().load, 2.0);
  EXPECT_TRUE(robot.state().in_motion);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 1.8, 1e-8);
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, stopsAtTheCornerWhereTheTcpChanges) {
  robot.script(client, "1", kSideways + kEnd + "ChangeTCP(0,0,50,0,0,0)" + kEnd + kDown);
  robot.wait(1s + 1us);
  EXPECT_LT(robot.state().velocities.norm(), 1e-4);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 2.0, 1e-8);
}

TEST_F(BlendingTest, takesANextMotionFromAnotherScript) {
  robot.script(client, "1", kSideways);
  robot.wait(400ms);
  robot.script(client, "2", kDown);
  expectSmooth(1300ms);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 1.8, 1e-8);
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, blendsWithWhatIsLeftWhenTheNextMotionComesLate) {
  robot.script(client, "1", kSideways);
  robot.wait(930ms);
  robot.script(client, "2", kDown);
  expectSmooth(900ms);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 1.93, 1e-8);
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, startsFromRestWhenTheNextMotionComesAfterTheEnd) {
  robot.script(client, "1", kSideways);
  robot.wait(1500ms);
  robot.script(client, "2", kDown);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 2.5, 1e-8);
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, takesOverAtTheProjectSpeedOfThatMoment) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  robot.wait(500ms);
  robot.operate(SetProjectSpeed{50});
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 0.8 + 1.8, 1e-8);
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, aRobotErrorBeforeTheCornerForgetsTheNextMotion) {
  robot.script(client, "1", kSideways + kEnd + kDown + kEnd + "QueueTag(1)");
  robot.wait(600ms);
  robot.heard(client);
  robot.operate(RaiseError{0x22, "too much force"});
  expectSmooth(1s);
  EXPECT_EQ(robot.heard(client), tag("01,false"));
  expectTravelled(60, 0);
}

TEST_F(BlendingTest, anOpenSafeguardHoldsTheArmInTheCorner) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  robot.wait(780ms);
  robot.operate(SetSafeguard{true});
  expectSmooth(400ms);
  EXPECT_FALSE(robot.state().in_motion);
  robot.operate(SetSafeguard{false});
  expectSmooth(1300ms);
  robot.waitUntilIdle();
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, countsEachOffsetFromItsCorner) {
  robot.script(client, "1", kSideways + kEnd + kSideways + kEnd + kSideways);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 2.6, 1e-8);
  expectTravelled(240, 0);
}

TEST_F(BlendingTest, failsAtTheCornerWhenTheNextMotionCannotBeMade) {
  robot.script(client, "1",
               kSideways + kEnd + "QueueTag(1)" + kEnd + "Line(\"CAP\",2000,0,0,180,0,90,100,200,0,false)" +
                   kEnd + "QueueTag(2)");
  robot.heard(client);
  robot.wait(999ms);
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_FALSE(robot.state().error);
  robot.waitUntilIdle();
  EXPECT_TRUE(robot.state().error);
  EXPECT_EQ(robot.heard(client), tag("01,true") + tag("02,false"));
  expectTravelled(80, 0);
}

TEST_F(BlendingTest, pausesInTheCornerAndGoesOnOnTheSamePath) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  robot.wait(850ms);
  robot.script(client, "2", "Pause()");
  expectSmooth(250ms);
  const RobotState paused = robot.state();
  EXPECT_FALSE(paused.in_motion);
  EXPECT_GT(travelled().y(), 70.0);
  EXPECT_LT(travelled().y(), 80.0);
  EXPECT_LT(travelled().z(), 0.0);
  robot.wait(1h);
  EXPECT_EQ(robot.state().joints, paused.joints);
  robot.script(client, "3", "Resume()");
  expectSmooth(1200ms);
  robot.waitUntilIdle();
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, takesOverWhileAPauseSlowsItDown) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  robot.wait(750ms);
  robot.script(client, "2", "Pause()");  // 100 ms of path are left to it
  expectSmooth(300ms);
  EXPECT_EQ(robot.state().queued_motions, 1);
  robot.script(client, "3", "Resume()");
  expectSmooth(1300ms);
  robot.waitUntilIdle();
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, blendsAfterAPauseWithWhatCameInIt) {
  robot.script(client, "1", kSideways);
  robot.wait(780ms);
  robot.script(client, "2", "Pause()");
  robot.wait(1s);  // stands at 880 ms of its path
  robot.script(client, "3", "QueueTag(1)" + kEnd + kDown);
  robot.heard(client);
  robot.wait(1s);
  EXPECT_EQ(robot.heard(client), "") << "nothing is done in a pause";
  EXPECT_EQ(robot.controller().nextEvent(), Instant::max());
  const Instant resumed = robot.now();
  robot.script(client, "4", "Resume()");
  EXPECT_EQ(robot.heard(client), ok("4") + tag("01,true"));
  expectSmooth(1000ms);
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - resumed), 1.0 + 0.1, 1e-8) << "100 ms are lost in speeding up";
  expectTravelled(80, -80);
}

TEST_F(BlendingTest, stopsInTheCornerAndForgetsTheRest) {
  robot.script(client, "1", kSideways + kEnd + kDown + kEnd + "QueueTag(1)");
  robot.wait(850ms);
  robot.heard(client);
  robot.script(client, "2", "StopAndClearBuffer()");
  expectSmooth(250ms);
  EXPECT_EQ(robot.heard(client), ok("2"));
  EXPECT_EQ(robot.state().queued_motions, 0);
  EXPECT_EQ(robot.controller().nextEvent(), Instant::max());
  const Eigen::Vector3d stopped = travelled();
  EXPECT_LT(stopped.y(), 80.0);
  EXPECT_LT(stopped.z(), 0.0);
  robot.script(client, "3", kDown);
  robot.waitUntilIdle();
  EXPECT_NEAR(travelled().y(), stopped.y(), 1e-6);
  EXPECT_NEAR(travelled().z(), stopped.z() - 80.0, 1e-6);
}

TEST_F(BlendingTest, aStopBeforeTheCornerForgetsTheNextMotion) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  robot.wait(600ms);
  robot.script(client, "2", "StopAndClearBuffer()");
  robot.wait(50ms);
  robot.script(client, "3", kDown);  // waits until the arm stands
  expectSmooth(1300ms);
  robot.waitUntilIdle();
  EXPECT_NEAR(travelled().y(), 60.0, 1e-3) << "50 mm by then, and 10 mm to slow down";
  EXPECT_NEAR(travelled().z(), -80.0, 1e-6);
}

TEST_F(BlendingTest, anEmergencyStopInTheCornerFreezesTheArm) {
  robot.script(client, "1", kSideways + kEnd + kDown);
  robot.wait(900ms);
  const arm::JointVector joints = robot.state().joints;
  robot.setEmergencyStop(true);
  robot.wait(1s);
  EXPECT_EQ(robot.state().joints, joints);
  EXPECT_TRUE(robot.state().velocities.isZero());
}

TEST_F(BlendingTest, tagsDroppedByAStopAreReportedWhereTheNextMotionTakesOver) {
  Settings settings;
  settings.faults.stale_tag.on = true;
  SimulatedRobot stale(settings);
  const ClientId one = stale.connect();
  stale.script(one, "1", kDown + kEnd + "QueueTag(5)" + kEnd + "StopAndClearBuffer()");
  stale.wait(1s);
  stale.heard(one);
  stale.script(one, "2", kSideways + kEnd + kDown);
  stale.wait(799ms);
  EXPECT_EQ(stale.heard(one), ok("2"));
  stale.wait(2ms);
  EXPECT_EQ(stale.heard(one), tag("05,true"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
