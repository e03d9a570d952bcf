// What may be done with the robot while motions are interrupted, and what becomes of those.
#include "interrupted_robot.h"

#include "cobot_command/blocks/jog.h"

namespace cobot_command::testing {
namespace {

using command::GroupState;
using ::testing::HasSubstr;

class WhileMotionsAreInterrupted : public ::testing::Test {
 protected:
  void SetUp() override {
    first = rig.submit(lineTo({517.5, -122.3, 361.05, 180, 0, 90}));
    second = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 20, 0, 0, 0})));
    ASSERT_TRUE(rig.passUntilZ(420));
    rig.expectInterrupted();
    place = rig.jointsDeg();
  }
  void expectAborted(GoalId id, const std::string& words) {
    const blocks::Outcome& outcome = rig.endOf(id);
    EXPECT_EQ(outcome.ending, Ending::CommandAborted) << outcome.error_description;
    EXPECT_THAT(outcome.error_description, HasSubstr(words));
  }
  void expectDenied(int error_id, const std::string& words) {
    const auto answer = rig.goOn();
    EXPECT_FALSE(answer.success);
    EXPECT_EQ(answer.error_id, error_id) << answer.message;
    EXPECT_THAT(answer.message, HasSubstr(words));
  }

  InterruptedRobot rig;
  GoalId first = 0;
  GoalId second = 0;
  std::array<double, 6> place{};
};

TEST_F(WhileMotionsAreInterrupted, theRobotMayBeMovedAwayAndHasToBeBroughtBack) {
  auto away = place;
  away[0] += 20;
  rig.moveTo(away);
  EXPECT_FALSE(rig.group().in_primary_position);
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Interrupted);
  expectDenied(0x8C02, "J1 is 20.00 deg");
  EXPECT_EQ(rig.outcome(first), nullptr);
  rig.moveTo(place);
  EXPECT_TRUE(rig.group().in_primary_position);
  rig.expectGoesOn();
  rig.expectDone(first);
  rig.expectDone(second);
  EXPECT_NEAR(rig.place().z(), 381.05, 1e-2);
}

TEST_F(WhileMotionsAreInterrupted, theRobotMayBeJogged) {
  blocks::JogGoal jog;
  jog.mode = static_cast<int>(blocks::JogMode::Axes);
  jog.directions[0] = 1;
  jog.increment_deg = 5;
  jog.speed = 20;
  rig.expectDone(rig.submit(jog));
  rig.pass(300ms);
  EXPECT_NEAR(rig.jointDeg(0) - place[0], 5, 0.01);
  expectDenied(0x8C02, "J1");
  jog.directions[0] = -1;
  rig.expectDone(rig.submit(jog));
  rig.pass(300ms);
  rig.expectGoesOn();
  rig.expectDone(second);
}

TEST_F(WhileMotionsAreInterrupted, nothingGoesOnAsLongAsTheRobotMoves) {
  const GoalId moving = rig.submit(moveJoints({20, 0, 90, 0, 90, 0}, 10));
  rig.pass(500ms);
  expectDenied(0x8C43, "moves");
  EXPECT_EQ(rig.endOf(moving).ending, Ending::Done);
}

TEST_F(WhileMotionsAreInterrupted, aGoalThatRefusesToWaitIsCarriedOutAndOneThatWaitsIsNot) {
  const GoalId waits = rig.submit(inMode(BufferMode::Buffered, lineBy({0, 0, 5, 0, 0, 0})));
  rig.expectDone(rig.submit(lineBy({0, 0, 10, 0, 0, 0})));
  EXPECT_FALSE(rig.accepted(waits));
  rig.expectDone(rig.submit(lineBy({0, 0, -10, 0, 0, 0})));
  rig.pass(200ms);
  rig.expectGoesOn();
  rig.expectDone(waits);
}

TEST_F(WhileMotionsAreInterrupted, aStopTakesThemAll) {
  rig.expectDone(rig.submit(blocks::StopGoal{}));
  expectAborted(first, "stop block");
  expectAborted(second, "stop block");
  EXPECT_EQ(rig.group().sequence, GroupState::Sequence::Idle);
  expectDenied(0x233, "nothing is interrupted");
  rig.expectDone(rig.submit(lineBy({0, 0, 10, 0, 0, 0})));
}

TEST_F(WhileMotionsAreInterrupted, aStopTakesThemAndWhatMovesMeanwhile) {
  const GoalId moving = rig.submit(moveJoints({60, 0, 90, 0, 90, 0}, 10));
  rig.pass(500ms);
  rig.expectDone(rig.submit(blocks::StopGoal{}));
  expectAborted(moving, "stop block");
  expectAborted(first, "stop block");
}

TEST_F(WhileMotionsAreInterrupted, theOneThatWasUnderWayTakesOthersWithItWhenItIsCancelled) {
  rig.cancel(first);
  expectAborted(first, "cancelled while it was suspended");
  expectAborted(second, "before it");
  expectDenied(0x233, "nothing");
}

TEST_F(WhileMotionsAreInterrupted, oneThatWaitsMayBeCancelledAlone) {
  rig.cancel(second);
  expectAborted(second, "cancelled");
  EXPECT_EQ(rig.outcome(first), nullptr);
  rig.expectGoesOn();
  rig.expectDone(first);
}

TEST_F(WhileMotionsAreInterrupted, aGoalThatTakesOverEndsThem) {
  rig.expectDone(rig.submit(inMode(BufferMode::Aborting, lineBy({0, 0, 10, 0, 0, 0}))));
  expectAborted(first, "taken over");
  expectAborted(second, "taken over");
}

TEST_F(WhileMotionsAreInterrupted, theyFailWithTheLink) {
  rig.dropConnections();
  EXPECT_EQ(rig.endOf(first).ending, Ending::Aborted);
  EXPECT_EQ(rig.endOf(first).error_id, 0x99);
  expectAborted(second, "the link was lost");
  EXPECT_NE(rig.group().sequence, GroupState::Sequence::Interrupted);
}

TEST_F(WhileMotionsAreInterrupted, finishLeavesTheOneThatWasUnderWay) {
  rig.finish();
  expectAborted(second, "finished");
  EXPECT_EQ(rig.outcome(first), nullptr);
  rig.expectGoesOn();
  rig.expectDone(first);
}

TEST(WhileAWaitIsInterrupted, finishEndsItAtOnceAndNamesIt) {
  InterruptedRobot rig;
  const GoalId id = rig.submit(good<blocks::WaitTimeGoal>());
  rig.pass(1s);
  rig.expectInterrupted();
  const command::FinishReport report = rig.finish();
  EXPECT_EQ(report.under_way, blocks::kBlock<blocks::WaitTimeGoal>);
  EXPECT_EQ(report.dropped, 0);
  EXPECT_EQ(rig.endOf(id).ending, Ending::CommandAborted);
}

TEST_F(WhileMotionsAreInterrupted, theyEndWithTheLayer) {
  rig.shutDown();
  expectAborted(first, "shutting down");
  expectAborted(second, "shutting down");
}

TEST_F(WhileMotionsAreInterrupted, anotherToolHasToBeTakenOffAgain) {
  auto tcp = good<blocks::ChangeTcpGoal>();
  rig.expectDone(rig.submit(tcp));
  rig.pass(500ms);
  expectDenied(0x8C22, "TCP");
  tcp.tcp_offset = {0, 0, 0, 0, 0, 0};
  tcp.weight = 0;
  tcp.mass_center = {0, 0, 0, 0, 0, 0};
  rig.expectDone(rig.submit(tcp));
  rig.pass(500ms);
  rig.expectGoesOn();
  rig.expectDone(second);
}

TEST_F(WhileMotionsAreInterrupted, anotherBaseHasToBeSetBack) {
  rig.expectDone(rig.submit(good<blocks::ChangeBaseGoal>()));
  rig.pass(500ms);
  expectDenied(0x8C24, "base");
}

TEST_F(WhileMotionsAreInterrupted, aSafeguardThatWasOpenIsForgotten) {
  rig.operate(simulator::SetSafeguard{true});
  rig.pass(500ms);
  rig.operate(simulator::SetSafeguard{false});
  rig.pass(500ms);
  rig.expectGoesOn();
  rig.expectDone(first);
}

}  // namespace
}  // namespace cobot_command::testing
