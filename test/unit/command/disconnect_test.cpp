// Connect: how it ends on request, what it delivers meanwhile, and what it ignores.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using LinkState = CommandStatus::LinkState;
using FailureKind = link::OpenFailure::Kind;

TEST(Connected, endsNormallyWhenCancelled) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  rig.cancel(goal);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  EXPECT_EQ(rig.latest().link, LinkState::Disconnected);
  EXPECT_EQ(rig.outcome(goal)->detail.as<LinkTimes>().last_lost, rig.now)
      << "LastLostTime of the block (5.3.1.1)";
  EXPECT_EQ(rig.latest().last_lost, std::nullopt) << "what was asked for is no loss";
  EXPECT_FALSE(rig.connectionOpen(link::Channel::Script));
  EXPECT_EQ(rig.core.nextDeadline(), std::nullopt);
}

TEST(Connected, tellsSinceItsExecutionWhenTheLinkWasMadeAndLost) {
  CoreRig rig;
  rig.now += 5s;
  const GoalId first = rig.submit(CoreRig::robot());
  ASSERT_NE(rig.progress(first).back().detail.find<LinkTimes>(), nullptr);
  EXPECT_EQ(rig.progress(first).back().detail.as<LinkTimes>().last_connected, std::nullopt);
  rig.open();
  const Instant made = rig.now;
  EXPECT_EQ(rig.progress(first).back().detail.as<LinkTimes>().last_connected, made);
  EXPECT_EQ(rig.progress(first).back().detail.as<LinkTimes>().last_lost, std::nullopt);
  rig.pass(7s);
  rig.close("cable pulled");
  EXPECT_EQ(rig.outcome(first)->detail.as<LinkTimes>().last_connected, made);
  EXPECT_EQ(rig.outcome(first)->detail.as<LinkTimes>().last_lost, rig.now);
  EXPECT_EQ(rig.latest().last_connected, made);

  const GoalId second = rig.submit(CoreRig::robot());
  EXPECT_EQ(rig.progress(second).back().detail.as<LinkTimes>().last_connected, std::nullopt)
      << "reset at Execute, as in the thesis";
  EXPECT_EQ(rig.progress(second).back().detail.as<LinkTimes>().last_lost, std::nullopt);
}

TEST(Connected, tellsOfTheLastLossAlsoWhenItWasClosedAndMadeAgainSince) {
  CoreRig rig;
  rig.connect();
  rig.pass(7s);
  rig.close("cable pulled");
  const Instant lost = rig.now;
  rig.pass(1s);
  rig.cancel(rig.connect());
  rig.pass(1s);
  rig.connect();
  EXPECT_EQ(rig.latest().last_lost, lost);
  EXPECT_EQ(rig.latest().last_connected, rig.now);
}

TEST(Connected, canBeCancelledAtEachStep) {
  for (int step = 0; step < 4; ++step) {
    CoreRig rig;
    rig.answers_lifesigns = false;
    const GoalId goal = rig.submit(CoreRig::robot());
    if (step == 1) rig.failOpen(FailureKind::Refused);
    if (step >= 2) rig.open();
    if (step == 3) {
      rig.listening = false;
      rig.answers_lifesigns = true;
      rig.pump();
    }
    rig.cancel(goal);
    ASSERT_NE(rig.outcome(goal), nullptr) << step;
    EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
    EXPECT_FALSE(rig.pendingOpen(link::Channel::Script));
    EXPECT_FALSE(rig.connectionOpen(link::Channel::Script));
    rig.discardSent();
  }
}

TEST(Connected, stopsTheRobotBeforeItDisconnects) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  const GoalId motion = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(motion), nullptr);
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  const GoalId refused = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(refused)->error_id, motion_error::kNotConnected);
  rig.reply(stop.id);
  EXPECT_EQ(rig.outcome(motion)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST(Connected, disconnectsEvenIfTheStopIsNotAnswered) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  const GoalId motion = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.cancel(goal);
  rig.takeScript();
  rig.pass(1s);
  EXPECT_EQ(rig.outcome(motion)->error_id, own_error::kStopNotConfirmed);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST(Connected, deliversTheStatusStreamAlsoWithoutAProject) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  const GoalId goal = rig.submit(CoreRig::robot());
  rig.failOpen(FailureKind::Refused);
  ASSERT_TRUE(rig.pendingOpen(link::Channel::Status));
  EXPECT_EQ(rig.pendingOpen(link::Channel::Status)->port, 5891);
  rig.open(link::Channel::Status);
  EXPECT_FALSE(rig.latest().status_stream);
  rig.status(StatusFrames());
  EXPECT_TRUE(rig.latest().status_stream);
  EXPECT_EQ(rig.latest().link, LinkState::Connecting);
  ASSERT_EQ(rig.robot_statuses.size(), 1u);
  EXPECT_EQ(rig.robot_statuses[0].project_running, true);
  rig.pass(1s);
  EXPECT_FALSE(rig.latest().status_stream);
  EXPECT_THAT(rig.latest().status_diagnosis, HasSubstr("has stopped"));
  rig.cancel(goal);
  EXPECT_FALSE(rig.connectionOpen(link::Channel::Status));
  EXPECT_TRUE(rig.latest().status_diagnosis.empty());
}

TEST(Connected, takesTheStatusPortOfItsGoal) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  ConnectGoal goal = CoreRig::robot();
  goal.status_port = 45891;
  const GoalId id = rig.submit(goal);
  EXPECT_EQ(rig.pendingOpen(link::Channel::Status)->port, 45891);
  rig.cancel(id);
  goal.status_port = 0;
  rig.submit(goal);
  EXPECT_FALSE(rig.pendingOpen(link::Channel::Status));
}

TEST(Connected, ignoresAndCountsEventsOfOldConnections) {
  CoreRig rig;
  rig.connect();
  rig.close("gone");
  const auto before = rig.latest().late_replies;
  rig.core.opened(1, rig.now);
  rig.core.received(1, "$TMSTA,10,01,01,true,*64\r\n", rig.now);
  rig.core.closed(1, "late", rig.now);
  rig.core.openFailed(99, {}, rig.now);
  rig.pump();
  EXPECT_EQ(rig.latest().late_replies, before + 4);
  EXPECT_EQ(rig.latest().link, LinkState::Disconnected);
}

TEST(Connected, keepsTheErrorUntilItIsExecutedAgain) {
  CoreRig rig;
  rig.connect();
  rig.close("gone");
  rig.pass(1h);
  EXPECT_TRUE(rig.outputs(kBlock<ConnectGoal>).error);
  EXPECT_FALSE(rig.outputs(kBlock<ConnectGoal>).error_description.empty());
  rig.submit(CoreRig::robot());
  EXPECT_FALSE(rig.outputs(kBlock<ConnectGoal>).error);
  EXPECT_TRUE(rig.outputs(kBlock<ConnectGoal>).error_description.empty());
}

TEST(Connected, endsEverythingAtShutDown) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  const GoalId motion = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.core.shutDown(rig.now);
  bool closed = false;
  bool stopped = false;
  for (const auto& action : rig.core.takeActions()) {
    if (std::holds_alternative<CloseConnection>(action)) closed = true;
    if (const auto* sent = std::get_if<SendBytes>(&action)) {
      EXPECT_FALSE(closed) << "nothing is sent after the connection is closed";
      EXPECT_THAT(sent->bytes, HasSubstr("StopAndClearBuffer()"));
      stopped = true;
    }
    if (const auto* end = std::get_if<GoalEnded>(&action)) {
      EXPECT_TRUE(end->goal == goal || end->goal == motion);
      EXPECT_EQ(end->outcome.ending, Ending::CommandAborted);
    }
  }
  EXPECT_TRUE(closed);
  EXPECT_TRUE(stopped);
  EXPECT_EQ(rig.core.nextDeadline(), std::nullopt);
}

}  // namespace
}  // namespace cobot_command::testing
