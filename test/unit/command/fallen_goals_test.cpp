// Goals that wait in front of the core, for a tf frame, say: they fall with what would make them fall in its
// own queue, and those that came later do not.

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

MoveAbsoluteGoal buffered() {
  return CoreRig::move(BufferMode::Buffered);
}

class FallenGoals : public ::testing::Test {
 protected:
  FallenGoals() { connection = rig.connect(); }

  /// A motion on its way.
  GoalId startMotion() {
    const GoalId id = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    return id;
  }

  /// That a goal that waited in front of the core begins nothing any more, and what its end says.
  void expectFallen(GoalId waited, const std::string& why) {
    ASSERT_FALSE(rig.fell.empty());
    EXPECT_GE(rig.fell.back().newest, waited);
    EXPECT_THAT(rig.fell.back().why, HasSubstr(why));
    const int sent = rig.scripts_sent;
    rig.handOn(waited, buffered());
    EXPECT_EQ(rig.scripts_sent, sent);
    ASSERT_NE(rig.outcome(waited), nullptr);
    EXPECT_EQ(rig.outcome(waited)->ending, Ending::CommandAborted);
    EXPECT_THAT(rig.outcome(waited)->error_description, HasSubstr(why));
    EXPECT_FALSE(rig.accepted(waited));
    EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).command_aborted) << "it has come to its block";
  }

  void expectBegun(GoalId id) {
    EXPECT_EQ(rig.outcome(id), nullptr);
    EXPECT_TRUE(rig.accepted(id));
    rig.discardSent();
  }

  CoreRig rig;
  GoalId connection = 0;
};

TEST_F(FallenGoals, fallWithAMotionThatFailsAndLaterOnesDoNot) {
  startMotion();
  const GoalId waits = rig.come();
  const GoalId behind = rig.come();
  rig.tag(rig.latest().open_tags.at(0), protocol::TagState::Incomplete);
  rig.discardSent();
  expectFallen(waits, "move_absolute, failed");
  expectFallen(behind, "move_absolute, failed");
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  expectBegun(rig.submit(buffered()));
}

TEST_F(FallenGoals, fallWithACommandThatIsRefusedByTheController) {
  rig.submit(CoreRig::move());
  const GoalId waits = rig.come();
  rig.reply(rig.takeScript().id, false, {1});
  rig.discardSent();
  expectFallen(waits, "move_absolute, failed");
}

TEST_F(FallenGoals, fallWithTheLinkAlsoWhenThatComesBack) {
  const GoalId waits = rig.come();
  rig.close("peer gone");
  rig.connect();
  expectFallen(waits, "the link was lost");
  expectBegun(rig.submit(buffered()));
}

TEST_F(FallenGoals, fallWithAStopThatFails) {
  startMotion();
  rig.submit(StopGoal{});
  const GoalId waits = rig.come();
  rig.reply(rig.takeScript().id, false, {1});
  rig.discardSent();
  expectFallen(waits, "the robot may still move");
}

TEST_F(FallenGoals, fallWithWhatAPauseWithoutReplyStops) {
  startMotion();
  rig.submit(ProgramControlGoal{});
  const GoalId waits = rig.come();
  rig.pass(30s);
  rig.discardSent();
  expectFallen(waits, "program_control got no reply");
  rig.shutDown();
  rig.discardSent();
}

TEST_F(FallenGoals, fallWithAStopThatCameBehindThemAlsoWhenNobodyHearsIt) {
  rig.cancel(connection);
  const GoalId waits = rig.come();
  EXPECT_EQ(rig.outcome(rig.submit(StopGoal{}))->ending, Ending::Rejected);
  rig.connect();
  expectFallen(waits, "stopped by the stop block");
}

TEST_F(FallenGoals, doNotFallWithAStopThatCameBeforeThem) {
  startMotion();
  const GoalId waits = rig.come();
  const GoalId stop = rig.come();
  const GoalId later = rig.come();
  rig.handOn(stop, StopGoal{});
  rig.reply(rig.takeScript().id);
  expectFallen(waits, "stopped by the stop block");
  rig.handOn(later, buffered());
  expectBegun(later);
}

TEST_F(FallenGoals, fallWithACancelAsFarAsTheyCameBeforeIt) {
  const GoalId running = startMotion();
  const GoalId waits = rig.come();
  const GoalId later = rig.come();
  rig.core.cancel(running, rig.now, waits);
  rig.pump();
  rig.reply(rig.takeScript().id);
  expectFallen(waits, "move_absolute, was cancelled");
  rig.handOn(later, buffered());
  expectBegun(later);
}

TEST_F(FallenGoals, doNotFallWithTheCancelOfOneThatWaitsForItsTurn) {
  startMotion();
  const GoalId queued = rig.submit(buffered());
  const GoalId waits = rig.come();
  rig.cancel(queued);
  rig.handOn(waits, buffered());
  rig.tag(rig.latest().open_tags.at(0));
  expectBegun(waits);
}

TEST_F(FallenGoals, fallWithFinishAsFarAsTheyCameBeforeIt) {
  startMotion();
  const GoalId waits = rig.come();
  const GoalId later = rig.come();
  rig.core.finish(FinishAfter::Move, rig.now, waits);
  rig.pump();
  rig.tag(rig.latest().open_tags.at(0));
  expectFallen(waits, kNothingBehindFinish);
  rig.handOn(later, buffered());
  expectBegun(later);
}

TEST_F(FallenGoals, doNotFallWhenTheyBeginNothing) {
  rig.submit(CoreRig::move());
  const GoalId check = rig.come();
  const GoalId pause = rig.come();
  rig.reply(rig.takeScript().id, false, {1});
  rig.discardSent();
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.check_only = true;
  rig.handOn(check, goal);
  EXPECT_EQ(rig.outcome(check)->ending, Ending::Rejected) << "for its own reason";
  rig.handOn(pause, ProgramControlGoal{});
  expectBegun(pause);
}

TEST_F(FallenGoals, doNotFallWithOneThatIsRefusedAsItComes) {
  const GoalId refused = rig.come();
  const GoalId waits = rig.come();
  MoveAbsoluteGoal goal = buffered();
  goal.target_pose = framedPose();
  rig.handOn(refused, goal);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kBaseUnknown);
  rig.handOn(waits, buffered());
  expectBegun(waits);
}

/// The robot, with an active base that is known: targets in frames need one.
StatusFrames standing() {
  return StatusFrames().with(protocol::item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0}));
}

TEST(FallenGoal, fallsWithOneThatIsRefusedWhenItsTurnComes) {
  CoreRig rig{std::nullopt, link::LinkSettings{}};
  rig.connect();
  rig.status(standing());
  rig.frames["table"] = *framedPose().frame_in_robot_base;
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  MoveAbsoluteGoal goal = buffered();
  goal.target_pose = framedPose();
  goal.target_pose->latest = true;
  const GoalId refused = rig.submit(goal);
  const GoalId waits = rig.come();
  rig.frames["table"].translation().x() += 0.1;
  rig.tag(rig.latest().open_tags.at(0));
  rig.status(standing());
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kFrameMoved);
  rig.handOn(waits, buffered());
  EXPECT_EQ(rig.outcome(waits)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(waits)->error_description, HasSubstr("move_absolute, was refused"));
  EXPECT_TRUE(rig.nothingSent());
}

}  // namespace
}  // namespace cobot_command::testing
