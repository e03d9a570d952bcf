// Who may execute: refused, buffered, aborting; and what falls with whom.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::AllOf;
using ::testing::HasSubstr;

MoveAbsoluteGoal moveWith(BufferMode mode, double x = 417.5) {
  MoveAbsoluteGoal goal = CoreRig::move(mode);
  goal.target[0] = x;
  return goal;
}

MoveAbsoluteGoal blended(BufferMode mode = BufferMode::Refuse, double x = 417.5) {
  MoveAbsoluteGoal goal = moveWith(mode, x);
  goal.blending_enable = true;
  goal.blending_value = 50;
  return goal;
}

/// Starts a motion whose tag is still to come.
GoalId start(CoreRig& rig, const Goal& goal) {
  const GoalId id = rig.submit(goal);
  rig.reply(rig.takeScript().id);
  return id;
}

void expectFallen(const CoreRig& rig, GoalId id, const std::string& words) {
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr(words));
}

/// A take-over whose stop failed.
void expectNotStopped(const CoreRig& rig, GoalId id, const std::string& words) {
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStopNotConfirmed);
  EXPECT_THAT(rig.outcome(id)->error_description, AllOf(HasSubstr("may still move"), HasSubstr(words)));
  EXPECT_THAT(rig.outcome(id)->remedy, HasSubstr("Make sure that the robot is at standstill"));
}

void expectDone(const CoreRig& rig, GoalId id) {
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
}

TEST(Arbiter, refusesWhatComesWhileAnotherCommandIsBusyAndNamesIt) {
  CoreRig rig;
  rig.connect();
  start(rig, CoreRig::move());
  const GoalId second = rig.submit(ChangeBaseGoal{});
  ASSERT_NE(rig.outcome(second), nullptr);
  EXPECT_EQ(rig.outcome(second)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(second)->error_id, motion_error::kOtherBlockBusy);
  EXPECT_THAT(rig.outcome(second)->error_description, HasSubstr("move_absolute"));
}

TEST(Arbiter, keepsABufferedGoalUntilTheOneInFrontIsDone) {
  CoreRig rig;
  rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_FALSE(rig.accepted(second));
  EXPECT_EQ(rig.progress(second).back().place_in_queue, 1);
  EXPECT_EQ(rig.latest().queue_depth, 2);
  rig.tag(rig.latest().open_tags.at(0));
  expectDone(rig, first);
  EXPECT_TRUE(rig.accepted(second));
  rig.reply(rig.takeScript().id);
  rig.tag(rig.latest().open_tags.at(0));
  expectDone(rig, second);
  EXPECT_EQ(rig.latest().queue_depth, 0);
}

TEST(Arbiter, countsApartWhatWasSentAndWhatWaits) {
  CoreRig rig;
  rig.connect();
  EXPECT_FALSE(rig.latest().waiting_return);
  start(rig, CoreRig::move());
  for (int i = 0; i < 3; ++i) rig.submit(moveWith(BufferMode::Buffered));
  EXPECT_EQ(rig.latest().commands_under_way, 1);
  EXPECT_EQ(rig.latest().commands_waiting, 3);
  EXPECT_EQ(rig.latest().queue_depth, 4);
  EXPECT_TRUE(rig.latest().waiting_return);
  rig.submit(StopGoal{});
  EXPECT_EQ(rig.latest().commands_waiting, 0);
  EXPECT_TRUE(rig.latest().waiting_return);
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.latest().commands_under_way, 0);
  EXPECT_FALSE(rig.latest().waiting_return);
}

TEST(Arbiter, runsBufferedGoalsInTheirOrderAndTellsEachItsPlace) {
  CoreRig rig;
  rig.connect();
  start(rig, CoreRig::move());
  const GoalId a = rig.submit(moveWith(BufferMode::Buffered, 401));
  const GoalId b = rig.submit(moveWith(BufferMode::Buffered, 402));
  const GoalId c = rig.submit(moveWith(BufferMode::Buffered, 403));
  EXPECT_EQ(rig.progress(a).back().place_in_queue, 1);
  EXPECT_EQ(rig.progress(b).back().place_in_queue, 2);
  EXPECT_EQ(rig.progress(c).back().place_in_queue, 3);
  rig.tag(rig.latest().open_tags.at(0));
  EXPECT_EQ(rig.progress(b).back().place_in_queue, 1);
  for (const char* x : {"401", "402", "403"}) {
    const auto script = rig.takeScript();
    EXPECT_THAT(script.script, HasSubstr(x));
    EXPECT_TRUE(rig.nothingSent());
    rig.reply(script.id);
    rig.tag(rig.latest().open_tags.at(0));
  }
  expectDone(rig, c);
}

TEST(Arbiter, takesACancelledGoalOutOfTheQueueAndLeavesTheOthers) {
  CoreRig rig;
  rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Buffered));
  const GoalId third = rig.submit(moveWith(BufferMode::Buffered));
  rig.cancel(second);
  expectFallen(rig, second, "before its turn");
  EXPECT_FALSE(rig.accepted(second));
  EXPECT_TRUE(rig.nothingSent()) << "the robot goes on";
  EXPECT_EQ(rig.outcome(first), nullptr);
  EXPECT_EQ(rig.progress(third).back().place_in_queue, 1);
  rig.discardSent();
}

TEST(Arbiter, dropsWhatWaitsBehindACancelledCommand) {
  CoreRig rig;
  rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Buffered));
  rig.cancel(first);
  expectFallen(rig, second, "move_absolute, was cancelled");
  EXPECT_EQ(rig.outcome(first), nullptr) << "it ends when the robot stands";
  rig.reply(rig.takeScript().id);
  expectFallen(rig, first, "cancelled");
  EXPECT_TRUE(rig.nothingSent());
}

TEST(Arbiter, dropsWhatWaitsBehindAFailedCommandAndShowsTheError) {
  CoreRig rig;
  rig.connect();
  const GoalId first = rig.submit(CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Buffered));
  rig.reply(rig.takeScript().id, false, {1});
  expectFallen(rig, second, "move_absolute, failed");
  EXPECT_EQ(rig.outcome(first)->error_id, motion_error::kRejected);
  EXPECT_EQ(rig.outputs(kBlock<MoveAbsoluteGoal>).error_id, motion_error::kRejected);
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).error);
}

TEST(Arbiter, abortsWhatRunsAndWhatWaitsAndThenRunsTheNewOne) {
  CoreRig rig;
  rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Buffered));
  const GoalId third = rig.submit(moveWith(BufferMode::Aborting, 300));
  expectFallen(rig, second, "taken over by move_absolute");
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  EXPECT_TRUE(rig.nothingSent()) << "nothing is sent before the robot stands";
  EXPECT_FALSE(rig.accepted(third));
  rig.reply(stop.id);
  expectFallen(rig, first, "taken over by move_absolute");
  EXPECT_TRUE(rig.accepted(third));
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, HasSubstr("300"));
  rig.reply(script.id);
  rig.tag(rig.latest().open_tags.at(0));
  expectDone(rig, third);
}

TEST(Arbiter, waitsForStandstillBeforeATakeOver) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId first = start(rig, CoreRig::move());
  rig.status(StatusFrames().moving());
  const GoalId second = rig.submit(moveWith(BufferMode::Aborting));
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().moving());
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.outcome(first), nullptr);
  rig.stream(StatusFrames());
  expectFallen(rig, first, "taken over");
  EXPECT_TRUE(rig.accepted(second));
  rig.discardSent();
}

TEST(Arbiter, takesOverAtOnceWhenNothingIsUnderWayAndTheRobotIsSeenToStand) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(moveWith(BufferMode::Aborting));
  EXPECT_TRUE(rig.accepted(goal));
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP("));
}

/// Another client's motion, or one that a pause holds in the controller, or whatever nobody can see.
TEST(Arbiter, stopsForATakeOverAlsoWhatIsNotOfThisLayer) {
  const std::vector<StatusFrames> kNotSeenToStand = {
      StatusFrames().moving(), StatusFrames().paused(),
      StatusFrames().with(protocol::item::ofBool("Safeguard_A", true)),
      StatusFrames().without("Joint_Speed").without("Joint_Angle")};
  for (const StatusFrames& frame : kNotSeenToStand) {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames());
    rig.pass(500ms);
    rig.status(frame);
    const GoalId goal = rig.submit(moveWith(BufferMode::Aborting));
    const auto stop = rig.takeScript();
    EXPECT_EQ(stop.script, "StopAndClearBuffer()");
    EXPECT_TRUE(rig.nothingSent());
    EXPECT_FALSE(rig.accepted(goal));
    rig.reply(stop.id);
    rig.stream(StatusFrames());
    EXPECT_TRUE(rig.accepted(goal));
    EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP("));
  }
}

TEST(Arbiter, stopsForATakeOverWhereNoStreamTellsThatTheRobotStands) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(moveWith(BufferMode::Aborting));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  EXPECT_FALSE(rig.accepted(goal));
  rig.reply(stop.id);
  EXPECT_TRUE(rig.accepted(goal));
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP("));
}

TEST(Arbiter, stopsBlendedMotionsThatAreDoneForTheirGoalsButStillMove) {
  CoreRig rig;
  rig.connect();
  expectDone(rig, start(rig, blended()));
  rig.submit(moveWith(BufferMode::Aborting));
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP("));
}

TEST(Arbiter, sendsABufferedGoalBehindABlendedOneAtOnceSoThatTheyBlend) {
  CoreRig rig;
  rig.connect();
  start(rig, CoreRig::move());
  const GoalId second = rig.submit(blended(BufferMode::Buffered, 401));
  const GoalId third = rig.submit(moveWith(BufferMode::Buffered, 402));
  rig.tag(rig.latest().open_tags.at(0));
  rig.reply(rig.takeScript().id);
  expectDone(rig, second);
  EXPECT_THAT(rig.takeScript().script, HasSubstr("402"));
  EXPECT_TRUE(rig.accepted(third));
}

TEST(Arbiter, endsATakeOverToWhenTheStopIsNotConfirmed) {
  CoreRig rig;
  rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Aborting));
  rig.reply(rig.takeScript().id, false, {1});
  EXPECT_EQ(rig.outcome(first)->error_id, own_error::kStopNotConfirmed);
  expectNotStopped(rig, second, "the controller refused StopAndClearBuffer()");
  EXPECT_TRUE(rig.nothingSent());
}

/// Its stop was for nobody else: so there is no other goal that could tell it.
TEST(Arbiter, endsATakeOverWithTheErrorOfItsOwnStop) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames().moving());
  const GoalId goal = rig.submit(moveWith(BufferMode::Aborting));
  const GoalId behind = rig.submit(moveWith(BufferMode::Buffered));
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames().moving(), 150);
  expectNotStopped(rig, goal, "the robot still moves after the accepted stop");
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).error);
  expectFallen(rig, behind, "may still move");
  EXPECT_FALSE(rig.accepted(goal));
  EXPECT_TRUE(rig.nothingSent());
}

TEST(Arbiter, letsTheLastTakeOverWin) {
  CoreRig rig;
  rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Aborting, 401));
  const GoalId third = rig.submit(moveWith(BufferMode::Aborting, 402));
  expectFallen(rig, second, "taken over");
  rig.reply(rig.takeScript().id);
  expectFallen(rig, first, "taken over");
  EXPECT_TRUE(rig.accepted(third));
  EXPECT_THAT(rig.takeScript().script, HasSubstr("402"));
}

TEST(Arbiter, dropsEverythingWithTheLinkAndSaysWhy) {
  CoreRig rig;
  const GoalId link = rig.connect();
  const GoalId first = start(rig, CoreRig::move());
  const GoalId second = rig.submit(moveWith(BufferMode::Buffered));
  rig.close("closed by the peer");
  EXPECT_EQ(rig.outcome(first)->error_id, motion_error::kLinkDropped);
  expectFallen(rig, second, "closed by the peer");
  EXPECT_EQ(rig.outcome(link)->error_id, connect_error::kDisconnected);
}

TEST(Arbiter, refusesAGoalThatTheFullQueueCannotTake) {
  CoreRig rig;
  rig.connect();
  start(rig, CoreRig::move());
  for (int i = 0; i < 64; ++i) EXPECT_EQ(rig.outcome(rig.submit(moveWith(BufferMode::Buffered))), nullptr);
  const GoalId last = rig.submit(moveWith(BufferMode::Buffered));
  ASSERT_NE(rig.outcome(last), nullptr);
  EXPECT_EQ(rig.outcome(last)->error_id, own_error::kQueueFull);
}

TEST(Arbiter, plansABufferedMotionFromTheEndOfTheOneInFrontOfIt) {
  CoreRig rig(arm::ArmModel::named("tm5-900").value(), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  start(rig, CoreRig::move());
  MoveRelativeGoal far;
  far.movement_command = static_cast<int>(Movement::Line);
  far.data_format = static_cast<int>(RelativeFormat::Cap);
  far.target = {600, 0, 0, 0, 0, 0};
  far.speed = 100;
  far.accel_time = 300;
  far.buffer_mode = static_cast<int>(BufferMode::Buffered);
  const GoalId too_far = rig.submit(far);
  ASSERT_NE(rig.outcome(too_far), nullptr);
  EXPECT_EQ(rig.outcome(too_far)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(too_far)->error_id, own_error::kUnreachable);
  far.target[0] = 50;
  EXPECT_EQ(rig.outcome(rig.submit(far)), nullptr);
}

TEST(Arbiter, leavesACommandThatDoesNotMoveToItsEnd) {
  CoreRig rig;
  rig.connect();
  const GoalId base = rig.submit(ChangeBaseGoal{});
  const auto script = rig.takeScript();
  rig.cancel(base);
  EXPECT_TRUE(rig.nothingSent()) << "its reply is as near as that of a stop would be";
  rig.reply(script.id);
  expectDone(rig, base);
}

}  // namespace
}  // namespace cobot_command::testing
