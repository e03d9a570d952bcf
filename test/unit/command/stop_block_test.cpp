// The stop block: a path of its own to the robot, and everything else ends.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

TEST(StopBlock, sendsTheStopAtOnceAndIsDoneWhenTheRobotStands) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId move = rig.submit(CoreRig::move());
  const auto script = rig.takeScript();
  const GoalId stop = rig.submit(StopGoal{});
  const auto frame = rig.takeScript();
  EXPECT_EQ(frame.script, "StopAndClearBuffer()");
  EXPECT_TRUE(rig.nothingSent()) << "one frame is enough";
  rig.reply(script.id);
  rig.status(StatusFrames().moving());
  rig.reply(frame.id);
  EXPECT_EQ(rig.outcome(stop), nullptr);
  EXPECT_TRUE(rig.outputs(kBlock<StopGoal>).busy);
  rig.stream(StatusFrames());
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
  ASSERT_NE(rig.outcome(move), nullptr);
  EXPECT_EQ(rig.outcome(move)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(move)->error_description, HasSubstr("stop block"));
}

TEST(StopBlock, worksWithoutACommandUnderWay) {
  CoreRig rig;
  rig.connect();
  const GoalId stop = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
  EXPECT_THAT(rig.outcome(stop)->error_description,
              HasSubstr("no status stream shows whether the robot is at standstill"));
}

TEST(StopBlock, isAnErrorWhenTheStreamIsLostBeforeTheRobotWasSeenToStand) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames().moving());
  rig.discardSent();
  const GoalId stop = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  rig.close("gone", link::Channel::Status);
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.pass(2s);
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->error_id, own_error::kStopNotConfirmed);
}

TEST(StopBlock, emptiesTheQueue) {
  CoreRig rig;
  rig.connect();
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  std::vector<GoalId> waiting;
  for (int i = 0; i < 50; ++i) waiting.push_back(rig.submit(CoreRig::move(BufferMode::Buffered)));
  rig.submit(StopGoal{});
  const auto frame = rig.takeScript();
  EXPECT_EQ(frame.script, "StopAndClearBuffer()");
  for (const GoalId id : waiting) {
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
  }
  rig.reply(frame.id);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(StopBlock, refusesCommandsWhileItStops) {
  CoreRig rig;
  rig.connect();
  rig.submit(StopGoal{});
  const GoalId move = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(move)->error_id, motion_error::kOtherBlockBusy);
  const GoalId next = rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.reply(rig.takeScript().id);
  EXPECT_TRUE(rig.accepted(next));
  rig.discardSent();
}

TEST(StopBlock, askedTwiceIsSentTwiceAndEndsTwice) {
  CoreRig rig;
  rig.connect();
  const GoalId first = rig.submit(StopGoal{});
  const GoalId second = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  ASSERT_NE(rig.outcome(first), nullptr);
  EXPECT_EQ(rig.outcome(first)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(second), nullptr) << "each has its own answer";
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(second)->ending, Ending::Done);
}

TEST(StopBlock, isTriedOutsideTheListenNodeAndSaysThatTheRobotMayStillMove) {
  CoreRig rig;
  rig.listening = false;
  rig.submit(CoreRig::robot());
  rig.open();
  const GoalId stop = rig.submit(StopGoal{});
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
  EXPECT_TRUE(rig.accepted(stop));
  rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::NotListening});
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(stop)->error_id, own_error::kStopNotConfirmed);
  EXPECT_THAT(rig.outcome(stop)->error_description, HasSubstr("isten"));
}

TEST(StopBlock, isDoneOutsideTheListenNodeWhenTheControllerTakesIt) {
  CoreRig rig;
  rig.connect();
  rig.listening = false;
  rig.pass(1s);
  ASSERT_EQ(rig.latest().link, CommandStatus::LinkState::NotListening);
  const GoalId stop = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
}

TEST(StopBlock, isTriedBeforeTheControllerHasSaidAWord) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  rig.submit(CoreRig::robot());
  rig.open();
  rig.discardSent();
  ASSERT_EQ(rig.latest().link, CommandStatus::LinkState::Probing);
  const GoalId stop = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
}

/// What was tried on a connection that comes to nothing ends with it, and blocks nothing.
TEST(StopBlock, endsWithAConnectionThatWasNeverEstablished) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const GoalId connect = rig.submit(CoreRig::robot());
  rig.open();
  const GoalId stop = rig.submit(StopGoal{});
  rig.discardSent();
  rig.close("gone");
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->error_id, motion_error::kLinkDropped);
  rig.cancel(connect);
  rig.answers_lifesigns = true;
  rig.connect();
  rig.submit(CoreRig::move());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(StopBlock, endsWhenTheConnectGoalRunsOutOfTime) {
  CoreRig rig;
  rig.listening = false;
  const GoalId connect = rig.submit(CoreRig::robot());
  rig.open();
  rig.pass(9500ms);
  const GoalId stop = rig.submit(StopGoal{});
  rig.takeScript();
  rig.pass(500ms);
  EXPECT_EQ(rig.outcome(connect)->error_id, connect_error::kTimeOut);
  ASSERT_NE(rig.outcome(stop), nullptr);
  EXPECT_EQ(rig.outcome(stop)->error_id, motion_error::kLinkDropped);
}

TEST(StopBlock, goesOutWhileTheNodeIsBeingLeft) {
  CoreRig rig;
  rig.connect();
  rig.submit(ExitListenNodeGoal{});
  rig.reply(rig.takeScript().id);
  ASSERT_EQ(rig.latest().link, CommandStatus::LinkState::NotListening);
  const GoalId stop = rig.submit(StopGoal{});
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
  rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::NotListening});
  EXPECT_EQ(rig.outcome(stop)->error_id, own_error::kStopNotConfirmed);
}

TEST(StopBlock, endsWithTheLink) {
  CoreRig rig;
  rig.connect();
  const GoalId stop = rig.submit(StopGoal{});
  rig.takeScript();
  rig.close("cable pulled");
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(stop)->error_id, motion_error::kLinkDropped);
}

}  // namespace
}  // namespace cobot_command::testing
