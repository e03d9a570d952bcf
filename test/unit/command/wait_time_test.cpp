// Times that are waited for in the queue.

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

constexpr int kBuffered = static_cast<int>(BufferMode::Buffered);

/// Connected to a robot that stands.
struct WaitTimeBlock : ::testing::Test, CoreRig {
  WaitTimeBlock() : CoreRig(std::nullopt, link::LinkSettings{}) {
    connect();
    status(StatusFrames());
  }
  GoalId wait(double time, int buffer_mode = 0) { return submit(WaitTimeGoal{time, buffer_mode}); }
  GoalId move(bool is_blended = false) {
    MoveAbsoluteGoal move = CoreRig::move(BufferMode::Buffered);
    move.blending_enable = is_blended;
    return submit(move);
  }
  void expectEnd(GoalId id, Ending ending) {
    ASSERT_NE(outcome(id), nullptr);
    EXPECT_EQ(outcome(id)->ending, ending) << outcome(id)->error_description;
  }
};

TEST_F(WaitTimeBlock, isDoneWhenItsTimeIsOverAndSendsNothing) {
  const GoalId id = wait(2);
  EXPECT_TRUE(accepted(id));
  EXPECT_TRUE(outputs(kBlock<WaitTimeGoal>).active);
  pass(1999ms);
  EXPECT_EQ(outcome(id), nullptr);
  pass(1ms);
  expectEnd(id, Ending::Done);
  EXPECT_EQ(outcome(id)->actual, 2s);
  EXPECT_TRUE(nothingSent());
}

TEST_F(WaitTimeBlock, isDoneAtOnceWithoutATime) {
  const GoalId id = wait(0);
  pass(0ms);
  expectEnd(id, Ending::Done);
}

/// "Drive for two seconds": who waits for the end of velocities waits for ever.
TEST_F(WaitTimeBlock, doesNotWaitForVelocitiesThatHaveNoEnd) {
  for (const bool is_awaited : {false, true}) {
    RunScriptGoal drive;
    drive.script = "ContinueVJog()\nSetContinueVJog(10,0,0,0,0,0)";
    drive.await_motion = is_awaited;
    drive.buffer_mode = kBuffered;
    const GoalId driving = submit(drive);
    reply(takeScript().id);
    if (is_awaited) tag(latest().open_tags.at(0));
    expectEnd(driving, Ending::Done);
    stream(StatusFrames().moving());
    const GoalId id = wait(0.2, kBuffered);
    EXPECT_EQ(progress(id).back().phase, Phase::Active) << is_awaited;
    pass(200ms);
    expectEnd(id, Ending::Done);
  }
}

TEST_F(WaitTimeBlock, staysHeldWhereNobodyTellsAnyMoreThatItIsNot) {
  const GoalId id = wait(10);
  stream(StatusFrames().paused());
  EXPECT_EQ(progress(id).back().phase, Phase::Held);
  close("gone", link::Channel::Status);
  pass(60s);
  EXPECT_EQ(outcome(id), nullptr);
  EXPECT_EQ(progress(id).back().phase, Phase::Held);
}

TEST_F(WaitTimeBlock, needsNoStatusStream) {
  close("gone", link::Channel::Status);
  const GoalId id = wait(1);
  pass(1s);
  expectEnd(id, Ending::Done);
}

TEST_F(WaitTimeBlock, beginsWhenTheMoveInFrontOfItIsDoneAndHoldsBackWhatComesBehindIt) {
  const GoalId before = move();
  const GoalId id = wait(1, kBuffered);
  const GoalId behind = move();
  reply(takeScript().id);
  EXPECT_EQ(progress(id).back().phase, Phase::Queued);
  EXPECT_EQ(progress(id).back().place_in_queue, 1);
  pass(700ms);
  tag(latest().open_tags.at(0));
  stream(StatusFrames());
  expectEnd(before, Ending::Done);
  EXPECT_EQ(progress(id).back().phase, Phase::Active);
  EXPECT_EQ(progress(id).back().place_in_queue, 0);
  pass(900ms);
  EXPECT_EQ(outcome(id), nullptr);
  EXPECT_TRUE(nothingSent());
  pass(100ms);
  expectEnd(id, Ending::Done);
  EXPECT_THAT(takeScript().script, HasSubstr("PTP"));
  EXPECT_EQ(outcome(behind), nullptr);
}

TEST_F(WaitTimeBlock, beginsWhenTheBlendedMotionInFrontOfItHasComeToItsEnd) {
  const GoalId before = move(true);
  reply(takeScript().id);
  expectEnd(before, Ending::Done);
  stream(StatusFrames().moving());
  const GoalId id = wait(1, kBuffered);
  EXPECT_THAT(progress(id).back().text, HasSubstr("until the robot is at standstill"));
  reply(takeScript().id);
  for (int i = 0; i < 20; ++i) {
    pass(100ms);
    status(StatusFrames().moving());
  }
  EXPECT_FALSE(accepted(id));
  tag(latest().open_tags.at(0));
  EXPECT_FALSE(accepted(id));
  stream(StatusFrames());
  EXPECT_TRUE(accepted(id));
  EXPECT_EQ(outcome(id), nullptr);
  pass(1s);
  expectEnd(id, Ending::Done);
}

/// Where no stream tells that the robot stands, or none any more, the motions around it must not blend
/// either.
TEST_F(WaitTimeBlock, asksForTheEndOfTheBlendedMotionInFrontOfItByATagAlone) {
  close("gone", link::Channel::Status);
  move(true);
  reply(takeScript().id);
  const GoalId id = wait(1, kBuffered);
  const GoalId behind = move();
  const auto asked = takeScript();
  EXPECT_EQ(asked.script, "QueueTag(1,0)");
  reply(asked.id);
  pass(3s);
  EXPECT_FALSE(accepted(id));
  EXPECT_TRUE(nothingSent());
  tag(latest().open_tags.at(0));
  EXPECT_EQ(progress(id).back().phase, Phase::Active);
  pass(999ms);
  EXPECT_TRUE(nothingSent());
  pass(1ms);
  expectEnd(id, Ending::Done);
  EXPECT_THAT(takeScript().script, HasSubstr("PTP"));
  EXPECT_EQ(outcome(behind), nullptr);
}

TEST_F(WaitTimeBlock, asksForNothingWhereTheBlendedMotionHasEnded) {
  move(true);
  reply(takeScript().id);
  stream(StatusFrames(), 60);
  EXPECT_TRUE(accepted(wait(1, kBuffered)));
  EXPECT_TRUE(nothingSent());
}

TEST_F(WaitTimeBlock, isDroppedWhereTheEndOfTheMotionInFrontOfItCannotBeWaitedFor) {
  move(true);
  reply(takeScript().id);
  const GoalId id = wait(1, kBuffered);
  reply(takeScript().id, false);
  expectEnd(id, Ending::CommandAborted);
  EXPECT_THAT(outcome(id)->error_description,
              HasSubstr("the end of a blended motion could not be waited for"));
}

TEST_F(WaitTimeBlock, leavesTheMotionInFrontOfItAloneWhenItIsCancelledBeforeItsTurn) {
  move(true);
  reply(takeScript().id);
  const GoalId id = wait(1, kBuffered);
  const GoalId behind = move();
  reply(takeScript().id);
  cancel(id);
  expectEnd(id, Ending::CommandAborted);
  EXPECT_TRUE(nothingSent());
  tag(latest().open_tags.at(0));
  stream(StatusFrames());
  EXPECT_THAT(takeScript().script, HasSubstr("PTP"));
  EXPECT_EQ(outcome(behind), nullptr);
}

TEST_F(WaitTimeBlock, endsWithAStopWhileItWaitsForTheEndOfTheMotionInFrontOfIt) {
  move(true);
  reply(takeScript().id);
  const GoalId id = wait(1, kBuffered);
  reply(takeScript().id);
  submit(StopGoal{});
  expectEnd(id, Ending::CommandAborted);
  EXPECT_THAT(takeScript().script, HasSubstr("StopAndClearBuffer"));
}

TEST_F(WaitTimeBlock, isRefusedWhileAnotherIsBusyAndDoesNotWantToWait) {
  move();
  reply(takeScript().id);
  EXPECT_EQ(outcome(wait(1))->error_id, motion_error::kOtherBlockBusy);
}

TEST_F(WaitTimeBlock, tellsWhatIsLeftOfItsTime) {
  const GoalId id = wait(2);
  EXPECT_EQ(progress(id).back().remaining, 2s);
  EXPECT_EQ(progress(id).back().text, "waits for 2 s to be over");
  const std::size_t told = progress(id).size();
  for (int i = 0; i < 100; ++i) {
    pass(15ms);
    status(StatusFrames());
  }
  EXPECT_LE(progress(id).back().remaining, 600ms);
  EXPECT_GE(progress(id).size(), told + 10);
  EXPECT_LE(progress(id).size(), told + 15) << "not with each frame";
}

TEST_F(WaitTimeBlock, hasItsTimeHeldByAPause) {
  const GoalId id = wait(1);
  pass(400ms);
  status(StatusFrames().paused());
  pass(500ms);
  status(StatusFrames().paused());
  EXPECT_EQ(progress(id).back().phase, Phase::Held);
  EXPECT_EQ(progress(id).back().remaining, 600ms);
  EXPECT_THAT(progress(id).back().text, HasSubstr("does not run"));
  pass(500ms);
  status(StatusFrames());
  EXPECT_EQ(progress(id).back().phase, Phase::Active);
  EXPECT_EQ(progress(id).back().remaining, 600ms);
  pass(599ms);
  EXPECT_EQ(outcome(id), nullptr);
  pass(1ms);
  expectEnd(id, Ending::Done);
}

TEST_F(WaitTimeBlock, endsAtOnceAndWithoutAStopWhenItIsCancelledAndTakesWhatWaitsBehindItWithIt) {
  const GoalId id = wait(10);
  const GoalId behind = move();
  cancel(id);
  expectEnd(id, Ending::CommandAborted);
  EXPECT_THAT(outcome(id)->error_description, HasSubstr("while it waited for 10 s to be over"));
  expectEnd(behind, Ending::CommandAborted);
  EXPECT_TRUE(nothingSent());
}

TEST_F(WaitTimeBlock, endsWithAStop) {
  const GoalId id = wait(10);
  const GoalId stop = submit(StopGoal{});
  expectEnd(id, Ending::CommandAborted);
  reply(takeScript().id);
  stream(StatusFrames(), 3);
  expectEnd(stop, Ending::Done);
}

TEST_F(WaitTimeBlock, endsWithAGoalThatTakesOverForWhichARobotThatStandsIsNotStopped) {
  const GoalId id = wait(10);
  const GoalId next = wait(1, static_cast<int>(BufferMode::Aborting));
  expectEnd(id, Ending::CommandAborted);
  EXPECT_TRUE(nothingSent());
  pass(1s);
  expectEnd(next, Ending::Done);
}

TEST_F(WaitTimeBlock, endsWithAnEmergencyStopOrAnErrorOfTheRobot) {
  const GoalId first = wait(10);
  status(StatusFrames().error(0x13, "PTP"));
  EXPECT_EQ(outcome(first)->error_id, own_error::kRobotError);
  status(StatusFrames());
  const GoalId second = wait(10);
  status(StatusFrames().emergencyStop());
  EXPECT_EQ(outcome(second)->error_id, motion_error::kLinkDropped);
  EXPECT_THAT(outcome(second)->error_description, HasSubstr("emergency stop"));
}

TEST_F(WaitTimeBlock, endsWithTheLinkAlsoWhenItsTimeWouldBeOverSoon) {
  const GoalId id = wait(0.1);
  close("gone");
  EXPECT_EQ(progress(id).back().phase, Phase::Stopping);
  pass(1s);
  EXPECT_EQ(outcome(id)->error_id, motion_error::kLinkDropped);
  EXPECT_THAT(outcome(id)->error_description, HasSubstr("gone"));
}

TEST_F(WaitTimeBlock, endsWhenItIsToFinishBehindTheMoveAndNotBehindTheCycle) {
  const GoalId id = wait(1);
  core.finish(FinishAfter::Cycle, now);
  pump();
  EXPECT_EQ(outcome(id), nullptr);
  core.finish(FinishAfter::Move, now);
  pump();
  expectEnd(id, Ending::CommandAborted);
}

}  // namespace
}  // namespace cobot_command::testing
