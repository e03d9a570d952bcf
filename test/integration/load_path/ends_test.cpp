// However a path ends, each of its goals ends once, with the point that it was at, and the robot stands.
#include "path_goals.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

class LoadPathEnds : public LoadPathCell {
 protected:
  void expectStands() {
    const arm::JointVector joints = cell.robot().joints;
    cell.pass(1s);
    EXPECT_LT((cell.robot().joints - joints).norm(), 1e-4);
  }
  /// What comes next has no trouble with what was.
  void expectNextWorks() {
    LoadPathGoal goal = turns(2, true);
    goal.path.back().termination_type = 0;
    expectDone(cell.submit(goal));
  }
};

/// Oracle 23.
TEST_F(LoadPathEnds, byAStopBeforeAllIsLoadedAreAnErrorOfThatGoal) {
  const GoalId id = cell.submit(turns(20, false));
  passUntilActive(id, 2);
  const Instant asked = cell.now();
  const GoalId stop = cell.submit(StopGoal{});
  const Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.ending, Ending::Aborted);
  EXPECT_EQ(outcome.error_id, 1007) << outcome.error_description;
  EXPECT_EQ(reportOf(id).error_index, 8) << "point 2 was active, and 3 to 7 in the buffer";
  EXPECT_EQ(cell.endOf(stop).ending, Ending::Done);
  EXPECT_LT(cell.now() - asked, 2s);
  expectStands();
  expectNextWorks();
}

TEST_F(LoadPathEnds, byAStopOnceAllIsLoadedAreNoError) {
  const GoalId id = cell.submit(turns(8, false));
  passUntilActive(id, 4);
  cell.submit(StopGoal{});
  EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
  expectStands();
  expectNextWorks();
}

TEST_F(LoadPathEnds, byAGoalThatTakesOverLetThatGoOn) {
  const GoalId id = cell.submit(turns(20, false));
  passUntilActive(id, 2);
  LoadPathGoal other = turns(2, false);
  other.buffer_mode = static_cast<int>(BufferMode::Aborting);
  const GoalId next = cell.submit(other);
  EXPECT_EQ(cell.endOf(id).error_id, 1007);
  expectDone(next);
}

TEST_F(LoadPathEnds, byACancelStopTheRobot) {
  for (const bool blended : {false, true}) {
    const GoalId id = cell.submit(turns(20, blended));
    passUntilActive(id, 3);
    cell.cancel(id);
    EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
    EXPECT_EQ(cell.endOf(id).error_id, 0);
    expectStands();
    expectNextWorks();
  }
}

TEST_F(LoadPathEnds, beforeAnythingWasSentSendNothing) {
  const GoalId id = cell.submit(turns(5, true));  // it waits for the next one
  cell.cancel(id);
  ASSERT_NE(cell.outcome(id), nullptr);
  EXPECT_EQ(cell.outcome(id)->ending, Ending::CommandAborted);
  EXPECT_TRUE(cell.scripts().empty());
}

/// Oracle 24.
TEST_F(LoadPathEnds, withTheLinkTellThePoint) {
  const GoalId first = cell.submit(turns(6, false));
  const GoalId second = cell.submit(turns(6, false, 6));
  passUntilActive(first, 3);
  cell.dropConnections();
  EXPECT_EQ(cell.endOf(first).ending, Ending::Aborted);
  EXPECT_EQ(cell.endOf(first).error_id, 1002) << cell.endOf(first).error_description;
  EXPECT_EQ(reportOf(first).error_index, 3);
  EXPECT_EQ(cell.endOf(second).ending, Ending::CommandAborted);
  const auto sent = cell.scripts().size();
  cell.pass(5s);
  EXPECT_EQ(cell.scripts().size(), sent) << "nothing resumes by itself";
}

TEST_F(LoadPathEnds, withAnEmergencyStopTellThePoint) {
  const GoalId id = cell.submit(turns(20, true));
  passUntilActive(id, 3);
  cell.operate(simulator::SetEmergencyStop{true});
  EXPECT_EQ(cell.endOf(id).ending, Ending::Aborted);
  EXPECT_EQ(cell.endOf(id).error_id, 1002) << cell.endOf(id).error_description;
  EXPECT_EQ(reportOf(id).error_index, 3);
}

TEST_F(LoadPathEnds, holdWithAPauseAndGoOn) {
  const GoalId id = cell.submit(turns(12, true));
  passUntilActive(id, 3);
  ProgramControlGoal pause;
  pause.command = static_cast<int>(ProgramCommand::Pause);
  expectDone(cell.submit(pause));
  cell.pass(20s);
  EXPECT_EQ(cell.outcome(id), nullptr);
  EXPECT_EQ(cell.progress(id).back().phase, Phase::Held);
  pause.command = static_cast<int>(ProgramCommand::Resume);
  expectDone(cell.submit(pause));
  expectDone(id);
  EXPECT_LT(reportOf(id).max_path_deviation, 0.5);
}

/// Oracle 26.
TEST_F(LoadPathEnds, whereItStandsAlreadyAreDoneAtOnce) {
  LoadPathGoal goal = turns(1, false);
  goal.path[0].joints = {0, 0, 90, 0, 90, 0};
  const GoalId id = cell.submit(goal);
  expectDone(id);
  EXPECT_EQ(*cell.outcome(id)->planned, Duration::zero());
}

TEST_F(LoadPathEnds, ofAThousandPointsWhereItStandsComeAtOnce) {
  LoadPathGoal goal;
  goal.path.assign(1000, pathPoint({0, 0, 90, 0, 90, 0}));
  goal.number_of_moves = 1000;
  const Instant began = cell.now();
  const GoalId id = cell.submit(goal);
  expectDone(id);
  EXPECT_LT(cell.now() - began, 200ms);
  EXPECT_EQ(placesOf(id).back().done_path_points, 1000);
}

TEST_F(LoadPathEnds, ofAWayAndPointsWithoutOneComeWithIt) {
  LoadPathGoal goal = turns(2, true);
  goal.path.resize(30, goal.path.back());
  goal.number_of_moves = 30;
  const GoalId id = cell.submit(goal);
  expectDone(id);
  EXPECT_EQ(cell.scripts().size(), 1U);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 6, 0.01);
  EXPECT_LT(*cell.outcome(id)->actual - *cell.outcome(id)->planned, 100ms);
}

LoadPathGoal thousandLines() {
  LoadPathGoal goal;
  for (int i = 0; i < 1000; ++i) {
    const int row = i / 20;
    const int column = row % 2 == 0 ? i % 20 : 19 - i % 20;
    path::PathPoint point = pathLine({417.5, -222.3 + 10.0 * column, 461.05 - 5.0 * row, 180, 0, 90});
    point.termination_type = static_cast<int>(path::Termination::Blend);
    point.command_tolerance = 2;
    goal.path.push_back(point);
  }
  goal.path.back().termination_type = 0;
  goal.number_of_moves = 1000;
  return goal;
}

/// Oracle 19.
TEST(LoadPathOfAThousandPoints, isOnePvtThatTheRobotFollows) {
  link::LinkSettings settings;
  settings.path.block_points = 20000;
  CoreAndRobot cell("tm5-900", {}, settings);
  cell.connect();
  const GoalId id = cell.submit(thousandLines());
  const Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
  EXPECT_EQ(cell.scripts().size(), 1U);
  EXPECT_LT(outcome.detail.as<PathReport>().max_path_deviation, 0.01);
}

TEST(LoadPathOfAThousandPoints, comesWithoutAGapInPieces) {
  CoreAndRobot cell;
  cell.connect();
  LoadPathGoal goal = thousandLines();
  for (std::size_t i = 99; i < 1000; i += 100) goal.path[i].termination_type = 0;
  const GoalId id = cell.submit(goal);
  const Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_description;
  EXPECT_EQ(cell.scripts().size(), 10U);
  EXPECT_LT(toSeconds(*outcome.actual - *outcome.planned), 0.1) << "each piece waits in the controller";
}

TEST(LoadPathOfAThousandPoints, isRefusedWhereItIsTooLongForOnePvt) {
  CoreAndRobot cell;
  cell.connect();
  const GoalId id = cell.submit(thousandLines());
  EXPECT_EQ(cell.endOf(id).error_id, 0x277);
  EXPECT_GT(cell.endOf(id).detail.as<PathReport>().error_index, 500);
}

TEST_F(LoadPathEnds, letTheFramesBeWrittenThatWereFrozenUntilThen) {
  const auto at = [](double x) {
    const arm::Pose pose(Eigen::Translation3d(x, 0, 0));
    return command::TableWrite{3, std::optional(tables::Frame{"", pose, 0})};
  };
  ASSERT_TRUE(cell.write(at(0)));
  LoadPathGoal goal = turns(2, false);
  goal.path[1] = pathLine({417.5, -122.3, 480, 180, 0, 90});
  goal.path[1].ref_frame_type = static_cast<int>(path::Reference::User);
  goal.path[1].ref_frame_id = 3;
  const GoalId id = cell.submit(goal);
  ASSERT_TRUE(cell.accepted(id));
  const auto refused = cell.write(at(0.1));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().error_id, 0x8C15);
  expectDone(id);
  EXPECT_TRUE(cell.write(at(0.1)));
}

TEST_F(LoadPathEnds, endThoughOneOfTheirPiecesHasNoWay) {
  LoadPathGoal goal = turns(3, false);
  goal.path[1] = goal.path[0];
  const GoalId id = cell.submit(goal);
  passUntilActive(id, 0);
  cell.pass(100ms);
  cell.cancel(id);
  EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
  expectStands();
  expectDone(cell.submit(goal));
}

TEST_F(LoadPathEnds, showAtOnceThatTheyAreBeingStopped) {
  const GoalId id = cell.submit(turns(20, true));
  passUntilActive(id, 3);
  cell.submit(StopGoal{});
  EXPECT_EQ(cell.progress(id).back().phase, Phase::Stopping);
  cell.endOf(id);
}

TEST_F(LoadPathEnds, stayEndedThoughTheyWaitedBehindABlendedMotion) {
  MoveAbsoluteGoal move = good<MoveAbsoluteGoal>();
  move.blending_enable = true;
  move.blending_value = 10;
  expectDone(cell.submit(move));
  const GoalId id = cell.submit(turns(5, true));
  EXPECT_TRUE(cell.accepted(id));
  cell.cancel(id);
  EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
  const auto sent = cell.scripts().size();
  expectStands();
  EXPECT_EQ(cell.scripts().size(), sent);
}

TEST_F(LoadPathEnds, byARefusedPieceLetThePieceInFrontEnd) {
  const GoalId first = cell.submit(turns(1, false));
  const GoalId second = cell.submit(turns(1, false, 1));
  const GoalId third = cell.submit(turns(1, false, 2));
  passUntilActive(first, 0);
  cell.operate(simulator::SetFault{"refuse_script", true, 1, 0, ""});
  expectDone(first);
  EXPECT_EQ(cell.endOf(third).ending, Ending::Aborted);
  expectDone(second);
}

TEST(LoadPathDeviation, stopsARobotThatIsOffItsPath) {
  CoreAndRobot cell;
  cell.connect();
  simulator::SetFault fault;
  fault.name = "pvt_linear";
  cell.operate(fault);
  LoadPathGoal goal = turns(20, true);
  goal.path[3].joints[2] = 100;
  goal.max_deviation = 0.001;
  const GoalId id = cell.submit(goal);
  const Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.ending, Ending::Aborted);
  EXPECT_EQ(outcome.error_id, 0x274) << outcome.error_description;
  const auto joints = cell.robot().joints;
  cell.pass(1s);
  EXPECT_EQ(cell.robot().joints, joints);
}

}  // namespace
}  // namespace cobot_command::testing
