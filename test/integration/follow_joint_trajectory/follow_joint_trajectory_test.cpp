// Trajectories from their goal to their end.

#include "block_goals.h"
#include "core_and_robot.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace std::chrono_literals;
using Trajectory = FollowJointTrajectoryGoal;

class Trajectories : public ::testing::Test {
 protected:
  explicit Trajectories(const simulator::Settings& settings = {}) : cell("tm5-900", settings) {
    cell.connect();
  }
  void expectDone(GoalId id) {
    const Outcome& outcome = cell.endOf(id);
    EXPECT_EQ(outcome.ending, Ending::Done) << outcome.error_id << " " << outcome.error_description;
  }
  void expectEnd(GoalId id, Ending ending, int error_id) {
    const Outcome& outcome = cell.endOf(id);
    EXPECT_EQ(outcome.ending, ending) << outcome.error_description;
    EXPECT_EQ(outcome.error_id, error_id) << outcome.error_description;
  }
  void expectStands() {
    const arm::JointVector joints = cell.robot().joints;
    cell.pass(1s);
    EXPECT_LT((cell.robot().joints - joints).norm(), 1e-4);
  }
  [[nodiscard]] double turned() const { return radToDeg(cell.robot().joints[0]); }

  CoreAndRobot cell;
};

/// There and back, from where the simulated arm stands: as long as it takes to interfere.
Trajectory swing() {
  auto goal = good<Trajectory>();
  goal.points.clear();
  for (int i = 0; i <= 8; ++i) {
    goal.points.push_back({0.5 * i, {i % 2 * 0.3, 0, kPi / 2, 0, kPi / 2, 0}, {}});
  }
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  return goal;
}

TEST_F(Trajectories, areDoneInTheirTime) {
  const GoalId id = cell.submit(good<Trajectory>());
  expectDone(id);
  EXPECT_NEAR(turned(), 10, 0.01);
  EXPECT_EQ(cell.scripts().size(), 1U);
  EXPECT_EQ(*cell.outcome(id)->planned, 2s);
  EXPECT_NEAR(toSeconds(*cell.outcome(id)->actual), 2, 0.1);
}

TEST_F(Trajectories, tellWhereTheyShouldBeAndAre) {
  const GoalId id = cell.submit(swing());
  expectDone(id);
  std::size_t told = 0;
  for (const Progress& progress : cell.progress(id)) {
    const auto* const place = progress.detail.find<TrajectoryPlace>();
    if (place == nullptr) continue;
    ++told;
    ASSERT_TRUE(place->actual);
    EXPECT_NEAR(place->desired[0], place->actual->at(0), 0.06);
    EXPECT_NEAR(place->desired[2], kPi / 2, 1e-9);
  }
  EXPECT_GT(told, 70U);
  EXPECT_LT(told, 90U) << "twenty times a second";
}

TEST_F(Trajectories, takeOverFromTheOneBefore) {
  const GoalId first = cell.submit(swing());
  cell.pass(700ms);
  Trajectory behind = swing();
  behind.points.erase(behind.points.begin());  // from wherever it stands
  const GoalId second = cell.submit(behind);
  expectEnd(first, Ending::CommandAborted, 0);
  expectDone(second);
}

TEST_F(Trajectories, areRefusedElsewhereAndLetTheRobotStand) {
  const GoalId first = cell.submit(swing());
  cell.pass(700ms);
  const GoalId second = cell.submit(swing());
  expectEnd(first, Ending::CommandAborted, 0);
  expectEnd(second, Ending::Rejected, own_error::kNotAtStart);
  expectStands();
}

TEST_F(Trajectories, thatAreWrongTakeNothingOver) {
  const GoalId first = cell.submit(swing());
  cell.pass(700ms);
  Trajectory wrong = swing();
  wrong.points[1].time = 0;
  expectEnd(cell.submit(wrong), Ending::Rejected, own_error::kTrajectoryInvalid);
  expectDone(first);
}

TEST_F(Trajectories, withoutPointsStopWhatIsUnderWay) {
  const GoalId first = cell.submit(swing());
  cell.pass(700ms);
  Trajectory empty = swing();
  empty.points.clear();
  expectDone(cell.submit(empty));
  expectEnd(first, Ending::CommandAborted, 0);
  expectStands();
  EXPECT_EQ(cell.scripts().size(), 2U) << "one PVT, and the stop";
}

TEST_F(Trajectories, standAtTheirStartAlreadyWhenThatIsAll) {
  Trajectory goal = swing();
  goal.points.resize(1);
  expectDone(cell.submit(goal));
  EXPECT_TRUE(cell.scripts().empty());
}

TEST_F(Trajectories, areStoppedByACancel) {
  const GoalId id = cell.submit(swing());
  cell.pass(700ms);
  cell.cancel(id);
  expectEnd(id, Ending::CommandAborted, 0);
  expectStands();
}

TEST_F(Trajectories, beginAtTheirTime) {
  Trajectory goal = swing();
  goal.starts_in = 3;
  const GoalId id = cell.submit(goal);
  EXPECT_TRUE(cell.accepted(id));
  cell.pass(2990ms);
  EXPECT_TRUE(cell.scripts().empty());
  cell.pass(20ms);
  EXPECT_EQ(cell.scripts().size(), 1U);
  expectDone(id);
}

TEST_F(Trajectories, thatWaitForTheirTimeEndWithACancelOrTheLink) {
  Trajectory goal = swing();
  goal.starts_in = 3;
  const GoalId first = cell.submit(goal);
  cell.pass(1s);
  cell.cancel(first);
  expectEnd(first, Ending::CommandAborted, 0);
  const GoalId second = cell.submit(goal);
  cell.pass(1s);
  cell.dropConnections();
  expectEnd(second, Ending::Aborted, motion_error::kLinkDropped);
  cell.pass(5s);
  EXPECT_TRUE(cell.scripts().empty());
}

TEST_F(Trajectories, holdWithAPauseAndGoOn) {
  const GoalId id = cell.submit(swing());
  cell.pass(700ms);
  cell.operate(simulator::PauseProject{});
  cell.pass(20s);
  EXPECT_EQ(cell.outcome(id), nullptr);
  cell.operate(simulator::ResumeProject{});
  expectDone(id);
}

TEST_F(Trajectories, takeLongerAtALowerProjectSpeed) {
  cell.operate(simulator::SetProjectSpeed{50});
  cell.pass(1s);
  const GoalId id = cell.submit(swing());
  expectDone(id);
  EXPECT_NEAR(toSeconds(*cell.outcome(id)->actual), 8, 0.1);
}

TEST_F(Trajectories, withALinkLostFail) {
  const GoalId id = cell.submit(swing());
  cell.pass(700ms);
  cell.dropConnections();
  expectEnd(id, Ending::Aborted, motion_error::kLinkDropped);
}

/// A controller that makes a PVT in straight parts is off the cubics of a long segment.
class TrajectoriesInStraightParts : public Trajectories {
 protected:
  static simulator::Settings settings() {
    simulator::Settings settings;
    settings.faults.pvt_linear.on = true;
    return settings;
  }
  TrajectoriesInStraightParts() : Trajectories(settings()) {}
};

TEST_F(TrajectoriesInStraightParts, stopWhereTheyLeaveTheirPathTolerance) {
  Trajectory goal = swing();
  goal.points = {{0, {0, 0, kPi / 2, 0, kPi / 2, 0}, {}},
                 {2, {0.5, 0.5, kPi / 2, 0, kPi / 2, 0}, {0.5, 0, 0, 0, 0, 0}},
                 {4, {1, 0, kPi / 2, 0, kPi / 2, 0}, {}}};
  for (auto& point : goal.points) point.velocities.resize(6, 0);
  goal.path_tolerance[0] = 0.02;
  const GoalId id = cell.submit(goal);
  expectEnd(id, Ending::Aborted, own_error::kPathTolerance);
  EXPECT_THAT(cell.endOf(id).detail.as<TrajectoryReport>().error_joint, ::testing::AnyOf(0, 1));
  expectStands();
  EXPECT_LT(turned(), 50);
  goal.points.erase(goal.points.begin());
  goal.path_tolerance[0] = -1;
  expectDone(cell.submit(goal));
}

class TrajectoriesThatAreLate : public Trajectories {
 protected:
  static simulator::Settings settings(Duration lag) {
    simulator::Settings settings;
    settings.pvt_lag = lag;
    return settings;
  }
  TrajectoriesThatAreLate() : Trajectories(settings(300ms)) {}
};

TEST_F(TrajectoriesThatAreLate, areNotOffTheirWay) {
  Trajectory goal = swing();
  goal.path_tolerance.fill(0.01);
  expectDone(cell.submit(goal));
}

/// The tag comes before the motion, and the arm is given its time.
TEST_F(Trajectories, areJudgedByTheirGoalToleranceAndItsTime) {
  cell.operate(simulator::SetFault{"early_tag", true, 1, 0, ""});
  Trajectory goal = swing();
  const GoalId id = cell.submit(goal);
  expectEnd(id, Ending::Aborted, own_error::kGoalTolerance);
  cell.pass(1s);  // it was told to stop
  expectStands();
  goal.points.erase(goal.points.begin());
  cell.operate(simulator::SetFault{"early_tag", true, 1, 0, ""});
  goal.goal_time_tolerance = 10;
  expectDone(cell.submit(goal));
}

}  // namespace
}  // namespace cobot_command::testing
