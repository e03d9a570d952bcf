// Connect: how it comes up, what it says when it does not, and how it goes down.

#include <functional>

#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using LinkState = CommandStatus::LinkState;
using FailureKind = link::OpenFailure::Kind;

/// A goal that ends at its timeout while every try ends in `trouble`.
Outcome timedOut(CoreRig& rig, const std::function<void()>& trouble) {
  const GoalId goal = rig.submit(CoreRig::robot());
  const Instant end = rig.now + 10s;
  while (rig.outcome(goal) == nullptr && rig.now < end + 1s) {
    if (rig.pendingOpen(link::Channel::Script)) trouble();
    rig.pass(50ms);
  }
  EXPECT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.now, end) << "the timeout is kept";
  EXPECT_FALSE(rig.connectionOpen(link::Channel::Script));
  EXPECT_FALSE(rig.pendingOpen(link::Channel::Script));
  EXPECT_EQ(rig.core.nextDeadline(), std::nullopt);
  rig.discardSent();
  return *rig.outcome(goal);
}

TEST(Connect, staysBusyWhileConnected) {
  CoreRig rig;
  const GoalId goal = rig.submit(CoreRig::robot());
  ASSERT_TRUE(rig.accepted(goal));
  ASSERT_TRUE(rig.pendingOpen(link::Channel::Script));
  EXPECT_EQ(rig.pendingOpen(link::Channel::Script)->host, "robot");
  EXPECT_EQ(rig.pendingOpen(link::Channel::Script)->port, 5890);
  EXPECT_EQ(rig.latest().link, LinkState::Connecting);
  rig.open();
  EXPECT_EQ(rig.latest().link, LinkState::Ready);
  EXPECT_EQ(rig.latest().listen_node, "Listen1");
  EXPECT_EQ(rig.latest().last_connected, rig.now);
  EXPECT_EQ(rig.progress(goal).back().phase, Phase::Connected);
  rig.pass(1h);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_TRUE(rig.outputs(kBlock<ConnectGoal>).busy);
  EXPECT_TRUE(rig.outputs(kBlock<ConnectGoal>).active);
}

TEST(Connect, triesAgainWithABackOffUntilTheProjectRuns) {
  CoreRig rig;
  const GoalId goal = rig.submit(CoreRig::robot());
  for (const Duration wait : {100ms, 200ms, 400ms, 800ms, 1000ms, 1000ms}) {
    rig.failOpen(FailureKind::Refused);
    EXPECT_THAT(rig.progress(goal).back().text, HasSubstr("no project"));
    rig.pass(wait - 1ns);
    EXPECT_FALSE(rig.pendingOpen(link::Channel::Script));
    rig.pass(1ns);
    ASSERT_TRUE(rig.pendingOpen(link::Channel::Script));
  }
  rig.open();
  EXPECT_EQ(rig.latest().link, LinkState::Ready);
  EXPECT_EQ(rig.outcome(goal), nullptr);
}

TEST(Connect, tellsItsTroublesApartAtTheTimeout) {
  const struct {
    FailureKind kind;
    int error_id;
    const char* words;
  } kRows[] = {{FailureKind::Refused, connect_error::kConnection, "refused"},
               {FailureKind::Unreachable, connect_error::kConnection, "unreachable"},
               {FailureKind::UnknownHost, connect_error::kConnection, "unknown host"},
               {FailureKind::TimedOut, connect_error::kConnection, "does not answer"},
               {FailureKind::Other, connect_error::kConnection, "as the system says"}};
  for (const auto& row : kRows) {
    CoreRig rig;
    const Outcome outcome = timedOut(rig, [&] { rig.failOpen(row.kind); });
    EXPECT_EQ(outcome.ending, Ending::Aborted);
    EXPECT_EQ(outcome.error_id, row.error_id) << row.words;
    EXPECT_THAT(outcome.error_description, HasSubstr(row.words));
    EXPECT_FALSE(outcome.remedy.empty());
  }
}

/// A proxy takes what it then cannot hand on.
TEST(Connect, keepsWhyThereWasNoConnectionUntilItsQuestionIsUnanswered) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const Instant late = rig.now + 9s;
  const Outcome outcome = timedOut(rig, [&] {
    if (rig.now < late) {
      rig.failOpen(FailureKind::Other);
    } else {
      rig.open();
    }
  });
  EXPECT_EQ(outcome.error_id, connect_error::kConnection) << outcome.error_description;
  EXPECT_THAT(outcome.error_description, HasSubstr("asking for the Listen node; before that: "));
  EXPECT_THAT(outcome.error_description, HasSubstr("as the system says"));
}

TEST(Connect, saysThatNothingAnswers) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const Outcome outcome = timedOut(rig, [&] { rig.open(); });
  EXPECT_EQ(outcome.error_id, connect_error::kNotACobot);
  EXPECT_THAT(outcome.error_description, HasSubstr("nothing answers"));
}

TEST(Connect, saysThatTheDeviceIsNotACobot) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const Outcome outcome = timedOut(rig, [&] {
    rig.open();
    rig.receive("SSH-2.0-OpenSSH_8.9\r\n");
    rig.receive("$HELLO,2,ab,*00\r\n");
  });
  EXPECT_EQ(outcome.error_id, connect_error::kNotACobot);
  EXPECT_THAT(outcome.error_description, HasSubstr("does not speak the protocol"));
}

TEST(Connect, saysThatItIsTheStatusPort) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  const Outcome outcome = timedOut(rig, [&] {
    rig.open();
    rig.receive(protocol::encode(protocol::StatusFrame{"3", 1, ""}));
  });
  EXPECT_EQ(outcome.error_id, connect_error::kNotACobot);
  EXPECT_THAT(outcome.error_description, HasSubstr("status port"));
}

TEST(Connect, saysThatTheConnectionIsClosedAtOnce) {
  CoreRig rig;
  const Outcome outcome = timedOut(rig, [&] {
    rig.answers_lifesigns = false;
    rig.open();
    rig.close("end of stream");
  });
  EXPECT_EQ(outcome.error_id, connect_error::kConnection);
  EXPECT_THAT(outcome.error_description, HasSubstr("closed the connection at once"));
}

TEST(Connect, saysThatTheCobotIsNotInTheListenNode) {
  CoreRig rig;
  rig.listening = false;
  const Outcome outcome = timedOut(rig, [&] { rig.open(); });
  EXPECT_EQ(outcome.error_id, connect_error::kTimeOut);
  EXPECT_THAT(outcome.error_description, HasSubstr("not in a Listen node"));
}

TEST(Connect, becomesReadyWhenTheFlowEntersTheListenNode) {
  for (const bool entry_message_seen : {true, false}) {
    CoreRig rig;
    rig.listening = false;
    const GoalId goal = rig.submit(CoreRig::robot());
    rig.open();
    EXPECT_EQ(rig.latest().link, LinkState::NotListening);
    rig.pass(3s);
    EXPECT_EQ(rig.outcome(goal), nullptr);
    rig.listening = true;
    if (entry_message_seen) {
      rig.say(protocol::ListenNodeEntered{"Listen1"});
    } else {
      rig.pass(1s);
    }
    EXPECT_EQ(rig.latest().link, LinkState::Ready);
    rig.pass(20s);
    EXPECT_EQ(rig.outcome(goal), nullptr);
  }
}

TEST(Connect, triesAgainWhenTheProjectStopsBeforeItWasReady) {
  CoreRig rig;
  rig.listening = false;
  const GoalId goal = rig.submit(CoreRig::robot());
  rig.open();
  rig.close("end of stream");
  const auto* outcome = rig.outcome(goal);
  EXPECT_EQ(outcome, nullptr);
  rig.pass(100ms);
  rig.listening = true;
  rig.open();
  EXPECT_EQ(rig.latest().link, LinkState::Ready);
}

TEST(Connect, staysConnectedWhenTheFlowLeavesTheListenNode) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  rig.listening = false;
  rig.pass(1s);
  EXPECT_EQ(rig.latest().link, LinkState::NotListening);
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("not in a Listen node"));
  rig.pass(400s);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_FALSE(rig.outputs(kBlock<ConnectGoal>).active);
  rig.listening = true;
  rig.pass(1s);
  EXPECT_EQ(rig.latest().link, LinkState::Ready);
}

TEST(Connect, endsWhenTheConnectionIsClosed) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  rig.now += 5s;
  rig.close("connection reset by peer");
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, connect_error::kDisconnected);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("connection reset by peer"));
  EXPECT_EQ(rig.latest().link, LinkState::Disconnected);
  EXPECT_EQ(rig.latest().last_lost, rig.now);
  EXPECT_EQ(rig.core.nextDeadline(), std::nullopt);
  EXPECT_THAT(rig.outputs(kBlock<ConnectGoal>).error_description, HasSubstr("Socket disconnected"));
}

TEST(Connect, findsADeadPeerWithinThreeSeconds) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  rig.pass(10s);
  rig.answers_lifesigns = false;
  rig.pass(3s);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->error_id, connect_error::kDisconnected);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("heartbeats"));
  rig.discardSent();
}

TEST(Connect, survivesASingleLostLifesign) {
  CoreRig rig;
  const GoalId goal = rig.connect();
  for (int round = 0; round < 20; ++round) {
    rig.answers_lifesigns = false;
    rig.pass(1s);
    rig.discardSent();
    rig.answers_lifesigns = true;
    rig.pass(1s);
  }
  EXPECT_EQ(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.latest().link, LinkState::Ready);
}

TEST(Connect, doesNotSendLifesignsIntoTheMotionQueue) {
  CoreRig rig;
  rig.connect();
  rig.traces.clear();
  rig.pass(10s);
  EXPECT_EQ(rig.scripts_sent, 0);
  EXPECT_EQ(rig.traces.size(), 20u) << "one question and one answer each second";
}

TEST(Connect, worksAgainAfterALoss) {
  CoreRig rig;
  for (int round = 0; round < 100; ++round) {
    const GoalId goal = rig.connect();
    const GoalId motion = rig.submit(CoreRig::move());
    const auto script = rig.takeScript();
    rig.close("gone");
    EXPECT_EQ(rig.outcome(motion)->error_id, motion_error::kLinkDropped);
    EXPECT_EQ(rig.outcome(goal)->error_id, connect_error::kDisconnected);
  }
  EXPECT_EQ(rig.opens, 100);
}

TEST(Connect, reconnectsByItselfOnlyWhenToldTo) {
  link::LinkSettings settings = CoreRig::noStatus();
  settings.auto_reconnect = true;
  CoreRig rig(std::nullopt, settings);
  const GoalId goal = rig.connect();
  const GoalId motion = rig.submit(CoreRig::move());
  rig.takeScript();
  rig.close("gone");
  EXPECT_EQ(rig.outcome(motion)->error_id, motion_error::kLinkDropped);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.pass(100ms);
  rig.open();
  EXPECT_EQ(rig.latest().link, LinkState::Ready);
  EXPECT_TRUE(rig.nothingSent()) << "nothing resumes by itself";

  rig.close("gone again");
  rig.pass(10s);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
}

}  // namespace
}  // namespace cobot_command::testing
