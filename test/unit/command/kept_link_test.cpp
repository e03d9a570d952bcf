// A link that is kept without a goal: it comes by itself, comes again, and gives way to a connect goal.

#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;
using ::testing::Not;
using State = CommandStatus::LinkState;

struct Rig : CoreRig {
  Rig() {
    core.keepConnected(robot(), now);
    pump();
  }
};

ConnectGoal robotAt(const std::string& host) {
  ConnectGoal goal = CoreRig::robot();
  goal.host = host;
  return goal;
}

TEST(KeptLink, isMadeWithoutAGoal) {
  Rig rig;
  rig.open();
  EXPECT_EQ(rig.latest().link, State::Ready);
  EXPECT_FALSE(rig.outputs(kBlock<ConnectGoal>).busy);
  const GoalId move = rig.submit(CoreRig::move());
  EXPECT_TRUE(rig.accepted(move));
  rig.discardSent();
}

TEST(KeptLink, triesForEver) {
  Rig rig;
  for (int i = 0; i < 1000; ++i) {
    rig.failOpen(link::OpenFailure::Kind::Refused);
    rig.pass(1s);
  }
  rig.open();
  EXPECT_EQ(rig.latest().link, State::Ready);
}

TEST(KeptLink, comesAgainAfterALossAndNothingResumesByItself) {
  Rig rig;
  rig.open();
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.close("cable pulled");
  EXPECT_EQ(rig.outcome(move)->error_id, motion_error::kLinkDropped);
  rig.pass(1s);
  rig.open();
  EXPECT_EQ(rig.latest().link, State::Ready);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(KeptLink, isTakenOverByAConnectGoalForTheSameController) {
  Rig rig;
  rig.open();
  const int opens = rig.opens;
  const GoalId goal = rig.submit(CoreRig::robot());
  EXPECT_TRUE(rig.accepted(goal));
  EXPECT_EQ(rig.progress(goal).back().phase, Phase::Connected);
  EXPECT_EQ(rig.opens, opens) << "the connection stays";
  rig.cancel(goal);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  rig.pass(10s);
  EXPECT_FALSE(rig.pendingOpen(link::Channel::Script)) << "who disconnects means it";
}

TEST(KeptLink, saysThatACancelledConnectGoalHasEndedIt) {
  Rig rig;
  rig.open();
  rig.cancel(rig.submit(CoreRig::robot()));
  EXPECT_EQ(rig.latest().link, State::Disconnected);
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("has ended the automatic link"));
  const GoalId move = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(move)->error_id, motion_error::kNotConnected);
  EXPECT_THAT(rig.outcome(move)->error_description, HasSubstr("send a connect goal"));
  rig.submit(CoreRig::robot());
  rig.open();
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr("automatic link")));
}

TEST(KeptLink, comesBackWhenTheLinkOfAGoalBehindACancelledOneIsLost) {
  Rig rig;
  rig.open();
  rig.cancel(rig.submit(CoreRig::robot()));
  rig.submit(CoreRig::robot());
  rig.open();
  rig.close("peer gone");
  rig.pass(10s);
  ASSERT_TRUE(rig.pendingOpen(link::Channel::Script)) << "only the cancel of the last goal means it";
  rig.open();
  EXPECT_EQ(rig.latest().link, State::Ready);
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr("automatic link")));
}

TEST(KeptLink, tellsOfTheRobotThatItHasLostInMotion) {
  Rig rig;
  rig.open();
  const ConnectGoal other = robotAt("another");
  const GoalId goal = rig.submit(other);
  rig.open();
  rig.submit(CoreRig::blended(50));
  rig.reply(rig.takeScript().id);
  rig.close("peer gone");
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("may still move"));
  rig.pass(10s);
  rig.open();
  EXPECT_EQ(rig.latest().link, State::Ready);
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("the link to another:5890 was lost during a motion"));
  rig.submit(other);
  rig.open();
  EXPECT_THAT(rig.latest().diagnosis, Not(HasSubstr("was lost"))) << "whether it moves is seen again";
}

TEST(KeptLink, comesBackWhenAConnectGoalForAnotherControllerFails) {
  Rig rig;
  rig.open();
  const GoalId goal = rig.submit(robotAt("wrong"));
  for (int i = 0; i < 1000 && rig.outcome(goal) == nullptr; ++i) {
    rig.failOpen(link::OpenFailure::Kind::UnknownHost);
    rig.pass(1s);
  }
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->error_id, connect_error::kConnection);
  rig.pass(1s);
  ASSERT_TRUE(rig.pendingOpen(link::Channel::Script));
  EXPECT_EQ(rig.pendingOpen(link::Channel::Script)->host, CoreRig::robot().host);
  rig.open();
  EXPECT_EQ(rig.latest().link, State::Ready);
}

TEST(KeptLink, tellsAConnectGoalThatTakesItOverWhenItWasMade) {
  Rig rig;
  rig.open();
  const Instant made = rig.now;
  rig.pass(3s);
  const GoalId goal = rig.submit(CoreRig::robot());
  EXPECT_EQ(rig.progress(goal).back().detail.as<LinkTimes>().last_connected, made);
  rig.cancel(goal);
  EXPECT_EQ(rig.outcome(goal)->detail.as<LinkTimes>().last_lost, rig.now);
}

TEST(KeptLink, givesWayToAConnectGoalForAnotherController) {
  Rig rig;
  rig.open();
  const ConnectGoal other = robotAt("another");
  const GoalId goal = rig.submit(other);
  ASSERT_TRUE(rig.pendingOpen(link::Channel::Script));
  EXPECT_EQ(rig.pendingOpen(link::Channel::Script)->host, "another");
  rig.open();
  EXPECT_EQ(rig.progress(goal).back().phase, Phase::Connected);
}

/// Whose goal has ended with its acceptance: nobody would be left to stop it.
TEST(KeptLink, isNotTakenAwayFromABlendedMotion) {
  Rig rig;
  rig.open();
  const GoalId motion = rig.submit(CoreRig::blended(50));
  rig.reply(rig.takeScript().id);
  ASSERT_NE(rig.outcome(motion), nullptr);
  const ConnectGoal other = robotAt("another");
  const GoalId refused = rig.submit(other);
  ASSERT_NE(rig.outcome(refused), nullptr);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kConnectBusy);
  EXPECT_THAT(rig.outcome(refused)->error_description, ::testing::HasSubstr("may still move"));
  const GoalId same = rig.submit(CoreRig::robot());
  EXPECT_EQ(rig.progress(same).back().phase, Phase::Connected) << "the same robot can be stopped";
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  rig.cancel(same);
  EXPECT_EQ(rig.outcome(rig.submit(other)), nullptr);
}

TEST(KeptLink, isNotTakenAwayFromACommandThatIsUnderWay) {
  Rig rig;
  rig.open();
  rig.submit(CoreRig::move());
  rig.discardSent();
  const ConnectGoal other = robotAt("another");
  const GoalId goal = rig.submit(other);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kConnectBusy);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("used by move_absolute"));
  EXPECT_THAT(rig.outcome(goal)->remedy, HasSubstr("Wait for its end"));
}

TEST(KeptLink, comesBackWhenTheLinkOfAConnectGoalWasLost) {
  Rig rig;
  rig.open();
  const GoalId goal = rig.submit(CoreRig::robot());
  rig.close("cable pulled");
  EXPECT_EQ(rig.outcome(goal)->error_id, connect_error::kDisconnected);
  rig.pass(1s);
  EXPECT_TRUE(rig.pendingOpen(link::Channel::Script));
}

TEST(FirstStatusFrame, isWaitedForBeforeCommandsAreTaken) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.submit(CoreRig::robot());
  rig.open();
  rig.open(link::Channel::Status);
  EXPECT_EQ(rig.latest().link, State::Probing);
  const GoalId early = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(early)->error_id, motion_error::kNotConnected);
  rig.status({});
  EXPECT_EQ(rig.latest().link, State::Ready);
}

TEST(FirstStatusFrame, isNotWaitedForForEver) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.submit(CoreRig::robot());
  rig.open();
  rig.failOpen(link::OpenFailure::Kind::Refused, link::Channel::Status);
  rig.pass(500ms);
  EXPECT_EQ(rig.latest().link, State::Ready);
}

}  // namespace
}  // namespace cobot_command::testing
