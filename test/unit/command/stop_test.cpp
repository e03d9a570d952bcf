// Cancelling a motion: the stop goes out at once, and the goal does not end before the robot stands.

#include <functional>

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

TEST(Cancel, endsWhenTheStopIsAccepted) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.progress(goal).back().phase, Phase::Stopping);
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  rig.reply(stop.id);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, 0);
  EXPECT_THAT(rig.outcome(goal)->error_description,
              HasSubstr("no status stream shows whether the robot is at standstill"));
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).command_aborted);
}

TEST(Cancel, waitsUntilTheRobotStands) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  rig.status(StatusFrames().moving());
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.stream(StatusFrames());
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
}

TEST(Cancel, isAnErrorWhenTheRobotDoesNotComeToRest) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.status(StatusFrames().moving());
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  rig.reply(rig.takeScript().id);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(rig.outcome(goal), nullptr);
    rig.pass(100ms);
    rig.status(StatusFrames().moving());
  }
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kStopNotConfirmed);
}

TEST(Cancel, isAnErrorWhenTheStreamIsLostBeforeTheRobotWasSeenToStand) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.status(StatusFrames().moving());
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  const auto stop = rig.takeScript();
  rig.close("gone", link::Channel::Status);
  rig.reply(stop.id);
  rig.pass(1999ms);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.pass(1ms);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kStopNotConfirmed);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("the stop was accepted, but"));
}

TEST(Cancel, waitsForAStreamThatComesBack) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.status(StatusFrames().moving());
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  const auto stop = rig.takeScript();
  rig.close("gone", link::Channel::Status);
  rig.reply(stop.id);
  rig.pass(200ms);
  rig.open(link::Channel::Status);
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.stream(StatusFrames());
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("the robot was stopped"));
}

TEST(Cancel, waitsUntilTheJointAnglesStandWhereThereAreNoSpeeds) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  const auto frame = [&](float j1) {
    rig.pass(15ms);
    rig.status(StatusFrames().at({j1, 0, 90, 0, 90, 0}).without("Joint_Speed"));
  };
  const GoalId goal = rig.submit(CoreRig::move());
  frame(0);
  rig.reply(rig.takeScript().id);
  frame(1);
  rig.cancel(goal);
  rig.reply(rig.takeScript().id);
  for (float j1 = 2; j1 < 3; j1 += 0.1F) frame(j1);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  for (int i = 0; i < 22; ++i) frame(3);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
}

TEST(Cancel, isAnErrorWhenTheStopIsNotAccepted) {
  const struct {
    std::function<void(CoreRig&, const std::string& id)> answer;
    const char* words;
  } kRows[] = {
      {[](CoreRig& rig, const std::string&) { rig.pass(1s); }, "no reply"},
      {[](CoreRig& rig, const std::string& id) { rig.reply(id, false, {1}); }, "refused"},
      {[](CoreRig& rig, const std::string&) {
         rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::NotListening});
       },
       "isten"},
  };
  for (const auto& row : kRows) {
    CoreRig rig;
    rig.connect();
    const GoalId goal = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    rig.cancel(goal);
    row.answer(rig, rig.takeScript().id);
    ASSERT_NE(rig.outcome(goal), nullptr) << row.words;
    EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
    EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kStopNotConfirmed);
    EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr(row.words));
  }
}

TEST(Cancel, worksBeforeTheReplyWhateverTheReplyIs) {
  for (const bool accepted : {true, false}) {
    CoreRig rig;
    rig.connect();
    const GoalId goal = rig.submit(CoreRig::move());
    const auto script = rig.takeScript();
    rig.cancel(goal);
    const auto stop = rig.takeScript();
    rig.reply(script.id, accepted, accepted ? std::vector<int>{} : std::vector<int>{1});
    EXPECT_EQ(rig.outcome(goal), nullptr);
    const auto late = rig.latest().late_replies;
    rig.tag(1);  // the motion was finished when the stop came: the cancel still has its way
    EXPECT_EQ(rig.latest().late_replies, late + 1);
    EXPECT_EQ(rig.outcome(goal), nullptr);
    rig.reply(stop.id);
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  }
}

TEST(Cancel, afterTheEndChangesNothing) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.tag(1);
  rig.cancel(goal);
  rig.cancel(12345);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(Cancel, twiceStopsOnce) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.cancel(goal);
  rig.cancel(goal);
  const auto stop = rig.takeScript();
  EXPECT_TRUE(rig.nothingSent());
  rig.reply(stop.id);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
}

TEST(Cancel, makesTheTagsOfBeforeMeanNothing) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal move = CoreRig::move();
  move.command_id = 5;
  const GoalId first = rig.submit(move);
  rig.reply(rig.takeScript().id);
  rig.cancel(first);
  rig.reply(rig.takeScript().id);

  // The number may still be reported (tmr_ros2 #15): another goes over the wire, the caller's id stays.
  const GoalId second = rig.submit(move);
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, HasSubstr("QueueTag(1,0)"));
  rig.reply(script.id);
  const auto late = rig.latest().late_replies;
  rig.tag(5);
  EXPECT_EQ(rig.outcome(second), nullptr) << "a stale tag completes nothing";
  EXPECT_EQ(rig.latest().late_replies, late + 1);
  rig.tag(1);
  ASSERT_NE(rig.outcome(second), nullptr);
  EXPECT_EQ(rig.outcome(second)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(second)->command_id_ack, 5);

  rig.submit(move);
  EXPECT_THAT(rig.takeScript().script, HasSubstr("QueueTag(5,0)")) << "its number is clean again";
}

TEST(Cancel, ofFiftyMotionsInARowLeavesAFreeTag) {
  CoreRig rig;
  rig.connect();
  for (int i = 0; i < 50; ++i) {
    const GoalId goal = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    rig.cancel(goal);
    rig.reply(rig.takeScript().id);
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  }
}

/// A goal that takes over is planned in the event that sends its stop.
TEST(Cancel, hasItsWholeTimeThoughPlanningTookLongBehindTheStop) {
  for (const bool answered : {true, false}) {
    CoreRig rig;
    rig.connect();
    const GoalId goal = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    rig.cancel(goal);
    const auto stop = rig.takeScript();
    rig.now += 20s;
    rig.core.advance(rig.now);
    rig.pump();
    EXPECT_EQ(rig.outcome(goal), nullptr);
    rig.pass(900ms);
    EXPECT_EQ(rig.outcome(goal), nullptr);
    answered ? rig.reply(stop.id) : rig.pass(100ms);
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->ending, answered ? Ending::CommandAborted : Ending::Aborted);
    EXPECT_THAT(rig.outcome(goal)->error_description,
                HasSubstr(answered ? "accepted the stop" : "no reply to StopAndClearBuffer()"));
  }
}

}  // namespace
}  // namespace cobot_command::testing
