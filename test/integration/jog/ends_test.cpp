// What else ends a jog, and what speaks against one.

#include "block_goals.h"
#include "jog_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

/// A licence for velocities.
class JogEnds : public ::testing::TestWithParam<bool> {
 protected:
  GoalId driving(JogMode mode = JogMode::Axes) {
    const GoalId id = cell.cell.submit(jog(mode, mode == JogMode::Axes ? 0 : 1, 1, 10));
    cell.hold(500ms);
    EXPECT_FALSE(cell.stands());
    return id;
  }
  const Outcome& endWhileHeld(GoalId id) {
    cell.hold(5s, 10ms, [&] { return cell.cell.outcome(id) != nullptr; });
    const Outcome& outcome = cell.cell.endOf(id);
    cell.cell.pass(10ms);  // to stand is to be below 0.1 deg/s
    return outcome;
  }
  JogCell cell{GetParam()};
};

TEST_P(JogEnds, withACancel) {
  const GoalId id = driving();
  cell.cell.cancel(id);
  const Outcome& outcome = endWhileHeld(id);
  EXPECT_EQ(outcome.ending, Ending::CommandAborted);
  EXPECT_THAT(outcome.error_description, HasSubstr("cancelled"));
  EXPECT_TRUE(cell.stands());
  EXPECT_EQ(cell.cell.scripts().back(), "StopAndClearBuffer()");
}

TEST_P(JogEnds, withTheStopBlock) {
  const GoalId id = driving();
  const GoalId stop = cell.cell.submit(StopGoal{});
  EXPECT_EQ(endWhileHeld(id).ending, Ending::CommandAborted);
  EXPECT_EQ(cell.cell.endOf(stop).ending, Ending::Done);
  EXPECT_TRUE(cell.stands());
}

TEST_P(JogEnds, withAGoalThatTakesOver) {
  const GoalId id = driving();
  auto goal = good<MoveAbsoluteGoal>();
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  const GoalId next = cell.cell.submit(goal);
  EXPECT_EQ(endWhileHeld(id).ending, Ending::CommandAborted);
  EXPECT_EQ(cell.cell.endOf(next).ending, Ending::Done) << cell.cell.endOf(next).error_description;
}

TEST_P(JogEnds, withAFinishAsWithARelease) {
  const GoalId id = driving();
  cell.cell.finish();
  EXPECT_EQ(reportOf(endWhileHeld(id)).ended_by, JogEnd::Released);
  EXPECT_TRUE(cell.stands());
}

TEST_P(JogEnds, withALostLinkAndSayThatNobodyCanStopIt) {
  const GoalId id = driving();
  cell.cell.dropConnections();
  const Outcome& outcome = endWhileHeld(id);
  EXPECT_EQ(outcome.ending, Ending::Aborted);
  EXPECT_EQ(outcome.error_id, motion_error::kLinkDropped);
  EXPECT_THAT(outcome.error_description,
              HasSubstr(GetParam() ? "keeps its velocity" : "at the controller ends within 0.2 s"));
  cell.cell.pass(200ms);
  EXPECT_EQ(cell.stands(), !GetParam());
}

TEST_P(JogEnds, byTheControllerItselfWhenTheLinkIsLostInAJogOfTheTcp) {
  const GoalId id = driving(JogMode::Frame);
  cell.cell.dropConnections();
  EXPECT_EQ(endWhileHeld(id).error_id, motion_error::kLinkDropped);
  cell.cell.pass(600ms);
  EXPECT_TRUE(cell.stands());
}

TEST_P(JogEnds, withAPauseAndNotGoOnBehindIt) {
  const GoalId id = driving();
  cell.cell.operate(simulator::PauseProject{});
  const Outcome& outcome = endWhileHeld(id);
  EXPECT_EQ(outcome.ending, Ending::CommandAborted);
  EXPECT_THAT(outcome.error_description, HasSubstr("paused"));
  cell.cell.operate(simulator::ResumeProject{});
  cell.hold(1s);
  EXPECT_TRUE(cell.stands());
}

TEST_P(JogEnds, withAnEmergencyStop) {
  const GoalId id = driving();
  cell.cell.operate(simulator::SetEmergencyStop{true});
  const Outcome& outcome = endWhileHeld(id);
  EXPECT_EQ(outcome.ending, Ending::Aborted);
  EXPECT_EQ(outcome.error_id, motion_error::kLinkDropped);
}

TEST_P(JogEnds, withAnErrorOfTheRobot) {
  const GoalId id = driving();
  cell.cell.operate(simulator::RaiseError{0x1234, "something"});
  const Outcome& outcome = endWhileHeld(id);
  EXPECT_EQ(outcome.ending, Ending::Aborted);
  EXPECT_EQ(outcome.error_id, own_error::kRobotError);
}

TEST_P(JogEnds, whenTheLayerShutsDown) {
  const GoalId id = driving();
  cell.cell.shutDown();
  EXPECT_EQ(cell.cell.endOf(id).ending, Ending::CommandAborted);
}

TEST_P(JogEnds, leavesARobotThatMoves) {
  const GoalId id = driving();
  static_cast<void>(cell.timeToStandstill());
  EXPECT_EQ(reportOf(cell.cell.endOf(id)).ended_by, JogEnd::Released);
  const GoalId move = cell.cell.submit(good<MoveAbsoluteGoal>());
  EXPECT_EQ(cell.cell.endOf(move).ending, Ending::Done) << cell.cell.endOf(move).error_description;
}

INSTANTIATE_TEST_SUITE_P(All, JogEnds, ::testing::Bool());

TEST(JogBegins, onlyWhileNothingIsUnderWay) {
  JogCell cell(true);
  const GoalId first = cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  cell.hold(200ms);
  const Outcome& second = cell.cell.endOf(cell.cell.submit(jog(JogMode::Axes, 1, 1, 10)));
  EXPECT_EQ(second.ending, Ending::Rejected);
  EXPECT_EQ(second.error_id, 0x8C33);
  cell.hold(100ms);
  EXPECT_EQ(cell.cell.outcome(first), nullptr) << "the first one goes on";
}

TEST(JogBegins, onlyWhileTheRobotStands) {
  JogCell cell(true);
  auto blended = good<MoveAbsoluteGoal>();
  blended.blending_enable = true;
  blended.blending_value = 50;
  EXPECT_EQ(cell.cell.endOf(cell.cell.submit(blended)).ending, Ending::Done) << "with its acceptance";
  const Outcome& outcome = cell.cell.endOf(cell.cell.submit(jog(JogMode::Axes, 0, 1, 10)));
  EXPECT_EQ(outcome.error_id, 0x8C33);
  EXPECT_THAT(outcome.error_description, HasSubstr("moves"));
}

TEST(JogBegins, notWhileTheRobotIsHeld) {
  JogCell cell(true);
  cell.cell.operate(simulator::PauseProject{});
  cell.cell.pass(100ms);
  const GoalId id = cell.cell.submit(jog(JogMode::Axes, 0, 1, 10));
  EXPECT_EQ(cell.cell.endOf(id).ending, Ending::CommandAborted);
  EXPECT_TRUE(cell.cell.scripts().empty());
}

TEST(JogKeepAlive, withoutAJogDoesNothing) {
  JogCell cell(true);
  cell.hold(200ms);
  EXPECT_TRUE(cell.cell.scripts().empty());
}

}  // namespace
}  // namespace cobot_command::testing
