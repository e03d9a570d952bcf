// What happens to motions while enabled data are out of sync: SRCI oracles 13 and 14.
#include "synchronised_robot.h"

namespace cobot_command::testing {
namespace {

using blocks::BufferMode;
using blocks::Ending;
using blocks::RiState;
using command::GroupState;
using ::testing::HasSubstr;
using Reaction = blocks::SyncReaction;

class SyncReactions : public ::testing::Test {
 protected:
  void enable(Reaction reaction, int delay = 0) {
    rig.enable([&](auto& s) {
      s.sync_reaction = static_cast<int>(reaction);
      s.sync_delay = delay;
    });
  }
  /// Until the layer has seen it.
  void changeThePendant() {
    rig.setTcp({0, 0, 160, 0, 0, 0});
    ASSERT_TRUE(rig.passUntil([&] { return !rig.report().out_cmd.data_in_sync.tools; }, 2s));
  }
  void changeItBack() {
    rig.setTcp({0, 0, 150, 0, 0, 0});
    ASSERT_TRUE(rig.passUntil([&] { return rig.report().out_cmd.data_in_sync.tools; }, 2s));
  }

  SynchronisedRobot rig;
};

/// SRCI oracle 13.
TEST_F(SyncReactions, interruptAtOnceHoldsTheRobotOnItsLineUntilItIsResumedInSync) {
  enable(Reaction::InterruptAtOnce, 500);
  const auto line = rig.line(200);
  rig.pass(1s);
  changeThePendant();
  const Instant seen = rig.now();
  rig.pass(480ms);
  EXPECT_EQ(rig.countSent("Pause()"), 0);
  rig.passUntil([&] { return rig.countSent("Pause()") == 1; }, 1s);
  EXPECT_NEAR(toSeconds(rig.now() - seen), 0.5, 0.02);
  rig.pass(500ms);
  EXPECT_FALSE(rig.isMoving());
  EXPECT_EQ(rig.outcome(line), nullptr);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Interrupted);
  EXPECT_EQ(rig.errorOf(rig.resume()), 0x8C30);
  changeItBack();
  rig.pass(1s);
  EXPECT_FALSE(rig.isMoving()) << "nothing resumes by itself";
  EXPECT_EQ(rig.endOf(rig.resume()).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(line).ending, Ending::Done);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Idle);
}

/// SRCI oracle 13.
TEST_F(SyncReactions, doNotComeWhereTheDataAreInSyncBeforeTheDelayIsOver) {
  enable(Reaction::InterruptAtOnce, 1500);
  const auto line = rig.line(200);
  rig.pass(1s);
  changeThePendant();
  rig.pass(200ms);
  changeItBack();
  EXPECT_EQ(rig.endOf(line).ending, Ending::Done);
  EXPECT_EQ(rig.countSent("Pause()"), 0);
}

/// Nothing has changed by that, and the next look shows it.
TEST_F(SyncReactions, doNotComeOfOneLookThatTheControllerRefuses) {
  enable(Reaction::InterruptAtOnce);
  const auto line = rig.line(40);
  rig.operate(simulator::SetFault{"refuse_listen_send", true, 1, 0, ""});
  EXPECT_EQ(rig.endOf(line).ending, Ending::Done);
  rig.pass(2s);
  EXPECT_EQ(rig.countSent("Pause()"), 0);
  EXPECT_EQ(rig.report().ri_state, RiState::Synchronized);
  changeThePendant();
}

/// SRCI oracle 14.
TEST_F(SyncReactions, interruptWhenEmptyLetsWhatIsThereEnd) {
  enable(Reaction::InterruptWhenEmpty);
  const auto first = rig.line(40);
  const auto second = rig.line(10);
  const auto third = rig.line(10);
  changeThePendant();
  EXPECT_EQ(rig.outcome(first), nullptr);
  EXPECT_EQ(rig.endOf(third).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(second).ending, Ending::Done);
  rig.pass(500ms);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Interrupted);
  const auto fourth = rig.line(10);
  rig.pass(2s);
  EXPECT_EQ(rig.outcome(fourth), nullptr);
  EXPECT_FALSE(rig.accepted(fourth));
  ASSERT_FALSE(rig.progress(fourth).empty());
  EXPECT_THAT(rig.progress(fourth).back().text, HasSubstr("gripper"));
  EXPECT_EQ(rig.errorOf(rig.line(10, BufferMode::Refuse)), 0x8C30);
  EXPECT_EQ(rig.errorOf(rig.line(10, BufferMode::Aborting)), 0x8C30);
  changeItBack();
  rig.pass(1s);
  EXPECT_FALSE(rig.accepted(fourth));
  EXPECT_EQ(rig.endOf(rig.resume()).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(fourth).ending, Ending::Done);
  EXPECT_EQ(rig.countSent("Pause()"), 0);
}

/// SRCI oracle 14.
TEST_F(SyncReactions, noEnableDoesNotDisableARobotThatIs) {
  enable(Reaction::NoEnable);
  const auto first = rig.line(40);
  const auto second = rig.line(10);
  changeThePendant();
  EXPECT_EQ(rig.endOf(second).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(first).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(rig.line(10)).ending, Ending::Done);
  rig.operate(simulator::RaiseError{1, "test"});
  rig.pass(200ms);
  rig.operate(simulator::ClearError{});
  rig.pass(200ms);
  EXPECT_EQ(rig.errorOf(rig.line(10)), 0x8C06) << "it was not enabled meanwhile";
  changeItBack();
  EXPECT_EQ(rig.endOf(rig.line(10)).ending, Ending::Done);
}

/// SRCI oracle 14.
TEST_F(SyncReactions, noEnableRefusesMotionsWhereTheInterfaceIsEnabledOutOfSync) {
  rig.setTcp({0, 0, 160, 0, 0, 0});
  enable(Reaction::NoEnable);
  EXPECT_EQ(rig.errorOf(rig.line(10)), 0x8C06);
  auto output = good<blocks::SetOutputGoal>();
  EXPECT_EQ(rig.endOf(rig.submit(output)).ending, Ending::Done) << "it moves nothing";
  changeItBack();
  EXPECT_EQ(rig.endOf(rig.line(10)).ending, Ending::Done);
}

/// SRCI oracle 14.
TEST_F(SyncReactions, noReactionIsNone) {
  enable(Reaction::None);
  const auto line = rig.line(40);
  changeThePendant();
  EXPECT_EQ(rig.endOf(line).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(rig.line(10)).ending, Ending::Done);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Idle);
}

TEST_F(SyncReactions, leaveTheStopAloneBehindWhichNothingIsLeftToResume) {
  enable(Reaction::InterruptAtOnce);
  const auto line = rig.line(200);
  const auto waits = rig.line(10);
  rig.pass(1s);
  changeThePendant();
  rig.pass(500ms);
  EXPECT_EQ(rig.endOf(rig.submit(blocks::StopGoal{})).ending, Ending::Done);
  EXPECT_NE(rig.outcome(line), nullptr);
  EXPECT_NE(rig.outcome(waits), nullptr);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Interrupted);
  changeItBack();
  rig.pass(100ms);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Idle);
}

TEST_F(SyncReactions, areOverWithTheInterfaceButWhatIsInterruptedWaitsToBeResumed) {
  enable(Reaction::InterruptAtOnce);
  const auto line = rig.line(60);
  rig.pass(1s);
  changeThePendant();
  rig.pass(500ms);
  rig.cancel(line - 1);  // the exchange_configuration in front of it
  rig.pass(1s);
  EXPECT_FALSE(rig.isMoving());
  EXPECT_EQ(rig.endOf(rig.resume()).ending, Ending::Done);
  EXPECT_EQ(rig.endOf(line).ending, Ending::Done);
}

TEST_F(SyncReactions, areOverWithTheLink) {
  enable(Reaction::InterruptAtOnce);
  const auto line = rig.line(200);
  rig.pass(1s);
  changeThePendant();
  rig.pass(500ms);
  rig.dropConnections();
  EXPECT_EQ(rig.errorOf(line), 0x99);
  EXPECT_EQ(rig.riState(), RiState::NotInitialized);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Idle);
}

/// Whoever held the robot when the reaction came lets it go, and it stands all the same.
class ReactionsToAHeldRobot : public SyncReactions {
 protected:
  void expectHeldUntilResumedInSync(blocks::GoalId line) {
    rig.pass(1s);
    EXPECT_FALSE(rig.isMoving());
    EXPECT_EQ(rig.outcome(line), nullptr);
    changeItBack();
    EXPECT_EQ(rig.endOf(rig.resume()).ending, Ending::Done);
    EXPECT_EQ(rig.endOf(line).ending, Ending::Done);
  }
};

TEST_F(ReactionsToAHeldRobot, outliveTheOverrideOfZero) {
  enable(Reaction::InterruptAtOnce);
  const auto line = rig.line(100);
  rig.pass(1s);
  rig.setSpeedOverride(0);
  rig.pass(500ms);
  changeThePendant();
  rig.setSpeedOverride(100);
  expectHeldUntilResumedInSync(line);
}

TEST_F(ReactionsToAHeldRobot, outliveTheSafeguard) {
  enable(Reaction::InterruptAtOnce);
  const auto line = rig.line(100);
  rig.pass(1s);
  rig.operate(simulator::SetSafeguard{true});
  rig.pass(500ms);
  changeThePendant();
  rig.operate(simulator::SetSafeguard{false});
  expectHeldUntilResumedInSync(line);
}

TEST_F(ReactionsToAHeldRobot, outliveAPathThatWasStopped) {
  enable(Reaction::InterruptAtOnce);
  const auto path = rig.submit(withTheGripper(10));
  rig.pass(2s);
  rig.setFeedrate(0);
  rig.pass(500ms);
  rig.setTcp({0, 0, 160, 0, 0, 0});
  ASSERT_TRUE(rig.passUntil([&] { return !rig.report().out_cmd.data_in_sync.tools; }, 2s));
  rig.setFeedrate(std::nullopt);
  expectHeldUntilResumedInSync(path);
}

TEST(RequiredInterface, refusesMotionsUntilItIsEnabled) {
  command::ExchangeRules rules;
  rules.required = true;
  SynchronisedRobot rig(rules);
  EXPECT_EQ(rig.errorOf(rig.line(10)), 0x8C05);
  rig.enable();
  EXPECT_EQ(rig.endOf(rig.line(10)).ending, Ending::Done);
}

TEST(RequiredInterface, stopsTheRobotWhenItIsDisabledWhileThatMoves) {
  command::ExchangeRules rules;
  rules.required = true;
  SynchronisedRobot rig(rules);
  const auto exchange = rig.enable();
  const auto line = rig.line(200);
  rig.pass(1s);
  rig.cancel(exchange);
  EXPECT_EQ(rig.endOf(line).ending, Ending::CommandAborted);
  EXPECT_EQ(rig.countSent("StopAndClearBuffer"), 1);
  EXPECT_EQ(rig.countMessages(0x8A02), 1);
}

}  // namespace
}  // namespace cobot_command::testing
