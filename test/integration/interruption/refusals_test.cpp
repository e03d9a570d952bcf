// When nothing can be interrupted, and when nothing is left of what was to be.
#include "interrupted_robot.h"

#include "cobot_command/blocks/follow_joint_trajectory.h"
#include "cobot_command/blocks/jog.h"

namespace cobot_command::testing {
namespace {

using ::testing::HasSubstr;

class AnInterruption : public ::testing::Test {
 protected:
  void expectRefused(int error_id, const std::string& words) {
    const auto answer = rig.interruptNow();
    EXPECT_FALSE(answer.success);
    EXPECT_EQ(answer.error_id, error_id) << answer.message;
    EXPECT_THAT(answer.message, HasSubstr(words));
  }
  void expectStillMoves(GoalId id) {
    rig.pass(100ms);
    EXPECT_FALSE(rig.stands());
    EXPECT_EQ(rig.outcome(id), nullptr);
  }

  InterruptedRobot rig;
};

TEST_F(AnInterruption, needsSomethingToInterrupt) {
  expectRefused(0x233, "no goal is running or queued");
  EXPECT_EQ(rig.goOn().error_id, 0x233);
}

TEST_F(AnInterruption, needsALink) {
  rig.dropConnections();
  expectRefused(0x10, "");
}

TEST_F(AnInterruption, isNotDoneTwice) {
  rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
  ASSERT_TRUE(rig.passUntilZ(420));
  const auto one = rig.interrupt();
  const auto other = rig.interrupt();
  rig.pass(1s);
  EXPECT_TRUE((*one)->success);
  EXPECT_TRUE((*other)->success) << "both have asked before the robot stood";
  expectRefused(0x233, "already");
}

TEST_F(AnInterruption, leavesAJogAndATrajectoryToTheirOwnEnds) {
  blocks::JogGoal jog;
  jog.mode = static_cast<int>(blocks::JogMode::Axes);
  jog.directions[0] = 1;
  jog.increment_deg = 30;
  jog.speed = 10;
  GoalId id = rig.submit(jog);
  rig.pass(500ms);
  expectRefused(0x233, "jog cannot");
  expectStillMoves(id);
  rig.endOf(id);
  rig.moveTo({0, 0, 90, 0, 90, 0});
  id = rig.submit(good<blocks::FollowJointTrajectoryGoal>());
  rig.pass(700ms);
  expectRefused(0x233, "follow_joint_trajectory cannot");
  EXPECT_EQ(rig.endOf(id).ending, Ending::Done) << rig.endOf(id).error_description;
}

TEST_F(AnInterruption, leavesAScriptThatSaysMoreThanMotions) {
  blocks::RunScriptGoal goal;
  goal.script = R"(Line("CAP",517.5,-122.3,361.05,180,0,90,100,200,0,false))"
                "\r\nChangeTCP(0,0,100,0,0,0)";
  goal.await_motion = true;
  const GoalId id = rig.submit(goal);
  ASSERT_TRUE(rig.passUntilZ(420));
  expectRefused(0x233, "run_script");
  expectStillMoves(id);
}

TEST_F(AnInterruption, needsToSeeWhereTheRobotStands) {
  simulator::Settings blind;
  blind.stream_items = {"Project_Run"};
  InterruptedRobot unseen(blind);
  unseen.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
  unseen.pass(500ms);
  const auto answer = unseen.interruptNow();
  EXPECT_EQ(answer.error_id, 0x208) << answer.message;
}

TEST_F(AnInterruption, findsNothingLeftWhereAStopComesInBetween) {
  const GoalId id = rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
  ASSERT_TRUE(rig.passUntilZ(420));
  const auto answer = rig.interrupt();
  rig.submit(blocks::StopGoal{});
  EXPECT_EQ(rig.endOf(id).ending, Ending::CommandAborted);
  rig.pass(1s);
  ASSERT_TRUE(answer->has_value());
  EXPECT_FALSE((*answer)->success);
  EXPECT_EQ(rig.goOn().error_id, 0x233);
}

TEST_F(AnInterruption, isDeniedToGoOnWhileTheRobotIsBeingStopped) {
  rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
  ASSERT_TRUE(rig.passUntilZ(420));
  static_cast<void>(rig.interrupt());
  EXPECT_EQ(rig.goOn().error_id, 0x8C43);
}

}  // namespace
}  // namespace cobot_command::testing
