// Goals that follow each other are one path.
#include "path_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class LoadPathChains : public LoadPathCell {};

LoadPathGoal section(const LoadPathGoal& goal, int start, int count) {
  LoadPathGoal part = goal;
  part.start_index = start;
  part.number_of_moves = count;
  return part;
}

/// Ten points that blend, and rest at the last one.
LoadPathGoal tenPoints() {
  LoadPathGoal goal = turns(10, true);
  goal.path.back().termination_type = static_cast<int>(path::Termination::Stop);
  return goal;
}

/// The lines that move the arm.
std::string pointsOf(const std::vector<std::string>& scripts) {
  std::string points;
  for (const std::string& script : scripts) {
    for (std::size_t at = script.find("PVTPoint"); at != std::string::npos;
         at = script.find("PVTPoint", at + 1)) {
      points += script.substr(at, script.find('\r', at) - at) + "\n";
    }
  }
  return points;
}

std::string wireOf(int goals) {
  CoreAndRobot cell;
  cell.connect();
  std::vector<GoalId> ids;
  for (int i = 0; i < goals; ++i) {
    ids.push_back(cell.submit(section(tenPoints(), i * 10 / goals, 10 / goals)));
  }
  for (const GoalId id : ids) {
    EXPECT_EQ(cell.endOf(id).ending, Ending::Done) << cell.endOf(id).error_description;
  }
  return pointsOf(cell.scripts());
}

/// Oracle 18.
TEST_F(LoadPathChains, areTheSameLinesOnTheWireAsOneGoal) {
  const std::string one = wireOf(1);
  EXPECT_GT(one.size(), 1000U);
  EXPECT_EQ(wireOf(2), one);
  EXPECT_EQ(wireOf(10), one);
}

/// Oracle 18: the second goal comes 1 s after the first block was sent.
TEST_F(LoadPathChains, loseTheBlendOfAGoalThatComesTooLate) {
  const GoalId first = cell.submit(section(tenPoints(), 0, 5));
  ASSERT_TRUE(cell.passUntil([&] { return !cell.scripts().empty(); }));
  cell.pass(1s);
  const GoalId second = cell.submit(section(tenPoints(), 5, 5));
  expectDone(first);
  expectDone(second);
  EXPECT_THAT(reportOf(first).blends_lost, ::testing::ElementsAre(4));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 30, 0.01);
}

TEST_F(LoadPathChains, waitForTheNextGoalAsLongAsTheyAreToldTo) {
  const Instant began = cell.now();
  cell.submit(section(tenPoints(), 0, 5));
  ASSERT_TRUE(cell.passUntil([&] { return !cell.scripts().empty(); }));
  EXPECT_EQ(cell.now() - began, 200ms);
}

TEST_F(LoadPathChains, doNotWaitWhereTheLastPointIsAStop) {
  cell.submit(tenPoints());
  EXPECT_EQ(cell.scripts().size(), 1U);
}

TEST_F(LoadPathChains, haveTwoPiecesAtTheController) {
  const GoalId id = cell.submit(turns(5, false));
  EXPECT_EQ(cell.scripts().size(), 2U);
  passUntilActive(id, 1);
  EXPECT_EQ(cell.scripts().size(), 3U);
  expectDone(id);
  EXPECT_EQ(cell.scripts().size(), 5U);
}

/// REFUSE does not refuse behind a path.
TEST_F(LoadPathChains, takeGoalsWhateverTheirBufferMode) {
  const GoalId first = cell.submit(turns(3, false));
  const GoalId second = cell.submit(turns(3, false, 3));
  EXPECT_TRUE(cell.accepted(second));
  MoveAbsoluteGoal move = good<MoveAbsoluteGoal>();
  const GoalId refused = cell.submit(move);
  ASSERT_NE(cell.outcome(refused), nullptr);
  EXPECT_EQ(cell.outcome(refused)->error_id, 0x11);
  move.buffer_mode = static_cast<int>(BufferMode::Buffered);
  cell.submit(move);
  const GoalId behind = cell.submit(turns(3, false));
  ASSERT_NE(cell.outcome(behind), nullptr) << "a command of another block ends the chain";
  EXPECT_EQ(cell.outcome(behind)->error_id, 0x11);
  expectDone(first);
  expectDone(second);
}

TEST_F(LoadPathChains, rememberTheTargetInFrontForIncrements) {
  const GoalId first = cell.submit(turns(2, true));
  LoadPathGoal goal = turns(1, false);
  goal.path[0].move_type = static_cast<int>(path::MoveType::Incremental);
  goal.path[0].joints = {5, 0, 0, 0, 0, 0};
  const GoalId second = cell.submit(goal);
  expectDone(first);
  expectDone(second);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 11, 0.01);
}

TEST_F(LoadPathChains, areWhatAGoalIsCheckedBehind) {
  const GoalId first = cell.submit(turns(2, true));
  passUntilActive(first, 0);
  LoadPathGoal goal = turns(1, false);
  goal.path[0].move_type = static_cast<int>(path::MoveType::Incremental);
  goal.path[0].joints = {5, 0, 0, 0, 0, 0};
  goal.check_only = true;
  const GoalId checked = cell.submit(goal);
  expectDone(checked);
  EXPECT_EQ(cell.outcome(first), nullptr);
  EXPECT_NEAR(radToDeg(reportOf(checked).joint_path.back().joints[0]), 11, 1e-6);
  goal.path[0].joints = {265, 0, 0, 0, 0, 0};
  EXPECT_EQ(cell.endOf(cell.submit(goal)).error_id, 1033) << "from where the path ends, and not from here";
  expectDone(first);
}

TEST_F(LoadPathChains, loseOnlyWhatNothingWasSentOf) {
  const GoalId first = cell.submit(section(turns(10, true), 0, 5));
  const GoalId second = cell.submit(section(turns(10, true), 5, 3));
  const GoalId third = cell.submit(section(turns(10, true), 8, 2));
  cell.cancel(second);
  EXPECT_EQ(cell.endOf(second).ending, Ending::CommandAborted);
  EXPECT_EQ(cell.endOf(third).ending, Ending::CommandAborted);
  EXPECT_THAT(cell.endOf(third).error_description, HasSubstr("load_path 2"));
  expectDone(first);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 15, 0.01);
}

TEST_F(LoadPathChains, endAllWhenAGoalIsCancelledThatIsUnderWayWithTheOnesInFront) {
  const GoalId first = cell.submit(section(tenPoints(), 0, 5));
  const GoalId second = cell.submit(section(tenPoints(), 5, 5));
  passUntilActive(first, 1);
  cell.cancel(second);
  EXPECT_EQ(cell.endOf(first).ending, Ending::CommandAborted);
  EXPECT_EQ(cell.endOf(second).ending, Ending::CommandAborted);
  const auto joints = cell.robot().joints;
  cell.pass(2s);
  EXPECT_EQ(cell.robot().joints, joints);
}

TEST_F(LoadPathChains, endEachGoalWhenItsOwnLastPointIsDone) {
  const GoalId first = cell.submit(section(tenPoints(), 0, 5));
  const GoalId second = cell.submit(section(tenPoints(), 5, 5));
  expectDone(first);
  EXPECT_EQ(cell.outcome(second), nullptr);
  EXPECT_LT(radToDeg(cell.robot().joints[0]), 20);
  expectDone(second);
}

/// A PVT has seven tags.
TEST_F(LoadPathChains, endEachOfTenGoalsWhenItsPointIsPassed) {
  std::vector<GoalId> ids;
  for (int i = 0; i < 10; ++i) ids.push_back(cell.submit(section(tenPoints(), i, 1)));
  double before = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    expectDone(ids[i]);
    const double turned = radToDeg(cell.robot().joints[0]);
    EXPECT_GT(turned, before) << i << " ended with the one in front of it";
    EXPECT_NEAR(turned, 3 * (static_cast<double>(i) + 1), 2) << i;
    before = turned;
  }
  EXPECT_EQ(cell.scripts().size(), 1U);
}

TEST_F(LoadPathChains, leaveThoseDoneThatWerePassedInFrontOfAStop) {
  std::vector<GoalId> ids;
  for (int i = 0; i < 10; ++i) ids.push_back(cell.submit(section(tenPoints(), i, 1)));
  ASSERT_TRUE(cell.passUntil([&] { return radToDeg(cell.robot().joints[0]) > 26; }));
  cell.cancel(ids.back());
  for (std::size_t i = 0; i < 8; ++i) expectDone(ids[i]);
  EXPECT_EQ(cell.endOf(ids.back()).ending, Ending::CommandAborted);
}

TEST_F(LoadPathChains, refuseAGoalThatCannotGoOnFromTheOneInFront) {
  const GoalId first = cell.submit(turns(2, false));
  LoadPathGoal goal = turns(2, false);
  goal.path[1].joints = {0, 0, 170, 0, 0, 0};
  const GoalId second = cell.submit(goal);
  ASSERT_NE(cell.outcome(second), nullptr);
  EXPECT_EQ(cell.outcome(second)->ending, Ending::Rejected);
  EXPECT_EQ(cell.outcome(second)->error_id, 1033);
  EXPECT_EQ(reportOf(second).error_index, 1);
  expectDone(first);
}

TEST_F(LoadPathChains, haveNoEndOfTheirOwn) {
  std::vector<GoalId> ids;
  for (int i = 0; i < 40; ++i) {
    ids.push_back(cell.submit(turns(5, i % 3 != 0, i % 8)));
    cell.pass(300ms);
  }
  for (const GoalId id : ids) expectDone(id);
}

}  // namespace
}  // namespace cobot_command::testing
