// A feedrate that counts for what the controller has, too: stopped, and planned anew from where the arm
// stands.
#include "path_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

/// At 100 %: a tenth more is too much for joint 1.
LoadPathGoal nearlyTooFast(LoadPathGoal goal) {
  goal.path[0].speed = 170;
  goal.path[0].acceleration = goal.path[0].deceleration = 1000;
  return goal;
}

class LoadPathRestart : public LoadPathCell {
 protected:
  [[nodiscard]] static LoadPathGoal quarterTurn() {
    LoadPathGoal goal;
    path::PathPoint point = pathPoint({90, 0, 90, 0, 90, 0});
    point.speed = 90;
    point.acceleration = point.deceleration = 180;
    goal.path = {point};
    goal.number_of_moves = 1;
    return goal;
  }
  /// The flange on half a circle of 100 mm about the place in the middle.
  [[nodiscard]] static LoadPathGoal halfCircle() {
    LoadPathGoal goal;
    path::PathPoint point = pathLine({517.5, 77.7, 461.05, 180, 0, 90});
    point.interpolation = static_cast<int>(path::Interpolation::Circular);
    point.via_pose = {417.5, -22.3, 461.05};
    goal.path = {point};
    goal.number_of_moves = 1;
    return goal;
  }
  [[nodiscard]] double joint1() { return radToDeg(cell.robot().joints[0]); }
  [[nodiscard]] bool stopsAt(double degrees) {
    return cell.passUntil([&] { return joint1() > degrees; });
  }
  [[nodiscard]] Eigen::Vector3d flange() {
    return mToMm(1) *
           arm::forwardKinematics(*arm::ArmModel::named("tm5-900"), cell.robot().joints).translation();
  }
};

TEST_F(LoadPathRestart, goesOnAtTheNewRateFromWhereTheArmStands) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(stopsAt(30));
  const auto answer = cell.setFeedrate(50, true);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->success);
  EXPECT_EQ(answer->from_point, 0);
  EXPECT_EQ(answer->effective, 100) << "until it is stopped";
  double fastest = 0;
  while (cell.outcome(id) == nullptr) {
    const double before = joint1();
    cell.pass(20ms);
    if (before > 60) fastest = std::max(fastest, (joint1() - before) / 0.02);
  }
  expectDone(id);
  EXPECT_NEAR(fastest, 45, 0.2);
  EXPECT_NEAR(joint1(), 90, 1e-3);
  EXPECT_LT(reportOf(id).max_joint_deviation, 0.5);
  EXPECT_TRUE(reportOf(id).blends_lost.empty());
}

TEST_F(LoadPathRestart, leavesNoPointOut) {
  const GoalId id = cell.submit(turns(9, true));
  const GoalId behind = cell.submit(turns(3, false, 9));
  passUntilActive(id, 4);
  EXPECT_EQ(cell.setFeedrate(50, true)->from_point, activeOf(id));
  expectDone(id);
  expectDone(behind);
  EXPECT_NEAR(joint1(), 36, 0.01);
  EXPECT_EQ(reportOf(id).points.size(), 9U);
  const auto& points = reportOf(id).points;
  EXPECT_NEAR(toSeconds(points[8].duration), 2 * toSeconds(points[1].duration), 0.01);
  EXPECT_EQ(placesOf(id).back().done_path_points, 9);
}

TEST_F(LoadPathRestart, foretellsWhatIsLeftAnew) {
  LoadPathGoal goal = quarterTurn();
  goal.path.push_back(goal.path[0]);
  goal.path[1].joints[0] = 0;
  goal.number_of_moves = 2;
  const GoalId id = cell.submit(goal);
  ASSERT_TRUE(stopsAt(50));
  cell.setFeedrate(50, true);
  expectDone(id);
  constexpr double kToStop = 0.4;  // and to be planned anew
  const auto& points = reportOf(id).points;
  EXPECT_GT(toSeconds(points[0].duration), 1.5 + kToStop) << "with what was driven before";
  for (const StepReport& point : points) {
    EXPECT_NEAR(toSeconds(point.start + point.duration), toSeconds(point.done), kToStop);
  }
  EXPECT_NEAR(toSeconds(*cell.outcome(id)->planned), toSeconds(*cell.outcome(id)->actual), kToStop);
}

TEST_F(LoadPathRestart, atTheSameRateIsAStopOnTheWay) {
  const GoalId id = cell.submit(turns(9, true));
  passUntilActive(id, 4);
  EXPECT_TRUE(cell.setFeedrate(100, true)->success);
  expectDone(id);
  EXPECT_NEAR(joint1(), 27, 0.01);
}

TEST_F(LoadPathRestart, stopsAgainOnTheWayAsOftenAsItIsAsked) {
  const GoalId id = cell.submit(turns(20, true));
  for (const int point : {2, 5, 9}) {
    passUntilActive(id, point);
    EXPECT_TRUE(cell.setFeedrate(100 - 5.0 * point, true)->success);
    cell.setFeedrate(120 - 5.0 * point, true);  // while it is being stopped
  }
  expectDone(id);
  EXPECT_NEAR(joint1(), 60, 0.01);
}

TEST_F(LoadPathRestart, staysOnAnArc) {
  const GoalId id = cell.submit(halfCircle());
  for (const double y : {-60, 40}) {  // in front of the place to pass, and behind it
    ASSERT_TRUE(cell.passUntil([&] { return flange().y() > y; }));
    EXPECT_TRUE(cell.setFeedrate(y < 0 ? 80 : 60, true)->success);
    cell.pass(100ms);
  }
  double farthest = 0;
  const Eigen::Vector3d middle(517.5, -22.3, 461.05);
  while (cell.outcome(id) == nullptr) {
    cell.pass(20ms);
    farthest = std::max(farthest, std::abs((flange() - middle).norm() - 100));
  }
  expectDone(id);
  EXPECT_LT(farthest, 0.1) << "[mm] off the circle";
  EXPECT_LT((flange() - Eigen::Vector3d(517.5, 77.7, 461.05)).norm(), 0.01);
}

TEST_F(LoadPathRestart, ofAStoppedPathLetsItGo) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(stopsAt(30));
  cell.setFeedrate(0);
  cell.pass(1s);
  const double stood = joint1();
  cell.setFeedrate(25, true);
  cell.pass(100ms);
  EXPECT_NEAR(joint1(), stood, 0.1) << "what is taken back does not go on";
  expectDone(id);
  EXPECT_NEAR(joint1(), 90, 1e-3);
}

TEST_F(LoadPathRestart, canBeStoppedOnItsWay) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(stopsAt(30));
  cell.setFeedrate(50, true);
  cell.setFeedrate(0);
  cell.pass(1min);
  EXPECT_EQ(cell.outcome(id), nullptr);
  EXPECT_EQ(cell.progress(id).back().phase, Phase::Held);
  EXPECT_THAT(cell.progress(id).back().text, HasSubstr("resume_path"));
  cell.setFeedrate(std::nullopt);
  expectDone(id);
}

TEST_F(LoadPathRestart, ofAScriptGoesOnWithItsFrames) {
  arm::Pose tool = arm::Pose::Identity();
  tool.translation().z() = 0.1;
  ASSERT_TRUE(cell.write({3, std::optional(tables::Tool{"", tool, 0})}));
  LoadPathGoal goal = turns(9, false);
  goal.execution = static_cast<int>(Execution::Script);
  goal.allow_approximation = true;
  for (path::PathPoint& point : goal.path) {
    point.pose_type = static_cast<int>(path::MovedFrame::Tool);
    point.pose_id = 3;
  }
  path::PathPoint last = pathLine({417.5, -122.3, 361.05, 180, 0, 90});
  last.pose_type = static_cast<int>(path::MovedFrame::Tool);
  last.pose_id = 3;
  goal.path.push_back(last);
  goal.number_of_moves = 10;
  const GoalId id = cell.submit(goal);
  passUntilActive(id, 3);
  EXPECT_TRUE(cell.setFeedrate(50, true)->success);
  expectDone(id);
  EXPECT_NEAR(flange().z(), 461.05, 0.01) << "the place of the tool";
  EXPECT_THAT(cell.scripts().back(), HasSubstr("ChangeTCP"));
}

TEST_F(LoadPathRestart, thatCannotBePlannedEndsTheGoalWhereTheRobotStands) {
  LoadPathGoal goal = turns(9, false);
  goal.execution = static_cast<int>(Execution::Script);
  for (path::PathPoint& point : goal.path) {
    point.speed = 36;
    point.acceleration = point.deceleration = 180;
  }
  const GoalId id = cell.submit(goal);
  const GoalId behind = cell.submit(goal);
  passUntilActive(id, 3);
  EXPECT_TRUE(cell.setFeedrate(51, true)->success);
  const Outcome& outcome = cell.endOf(id);
  EXPECT_EQ(outcome.ending, Ending::Aborted);
  EXPECT_EQ(outcome.error_id, own_error::kRestNotPlanned);
  EXPECT_THAT(outcome.error_description, HasSubstr("at a feedrate of 51 %"));
  EXPECT_EQ(reportOf(id).error_index, 3);
  EXPECT_EQ(cell.endOf(behind).ending, Ending::CommandAborted);
}

TEST_F(LoadPathRestart, isRefusedWhereAJointWouldBeTooFastAlsoOfWhatIsSent) {
  const GoalId id = cell.submit(nearlyTooFast(quarterTurn()));
  ASSERT_TRUE(stopsAt(30));
  EXPECT_TRUE(cell.setFeedrate(110)->success) << "of what comes";
  EXPECT_EQ(cell.setFeedrate(110, true)->error_id, own_error::kJointSpeed);
  expectDone(id);
}

TEST_F(LoadPathRestart, letsTheGoalBeCancelled) {
  for (const Duration when : {0ms, 20ms, 200ms}) {
    const GoalId id = cell.submit(turns(9, true));
    passUntilActive(id, 2);
    cell.setFeedrate(50, true);
    cell.pass(when);
    cell.cancel(id);
    EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
    expectDone(cell.submit(turns(1, false, -1)));
  }
}

TEST_F(LoadPathRestart, isRefusedLikewiseWhileItIsBeingStopped) {
  const GoalId id = cell.submit(nearlyTooFast(quarterTurn()));
  ASSERT_TRUE(stopsAt(30));
  EXPECT_TRUE(cell.setFeedrate(50, true)->success);
  const auto answer = cell.setFeedrate(110);
  EXPECT_EQ(answer->error_id, own_error::kJointSpeed);
  EXPECT_EQ(cell.setFeedrate(80)->from_point, 0);
  expectDone(id);
}

TEST_F(LoadPathRestart, tellsWhomeverStopsItMeanwhile) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(stopsAt(30));
  cell.setFeedrate(50, true);
  cell.cancel(id);
  EXPECT_THAT(cell.endOf(id).error_description, HasSubstr("cancelled; the robot was stopped"));
}

TEST_F(LoadPathRestart, doesNotCountABlendAsLostThatTakesPlaceBehindIt) {
  LoadPathGoal first = turns(3, true);
  const GoalId id = cell.submit(first);
  passUntilActive(id, 1);  // its open end is sent
  const GoalId behind = cell.submit(turns(3, false, 3));
  cell.pass(100ms);
  EXPECT_TRUE(cell.setFeedrate(50, true)->success);
  expectDone(id);
  expectDone(behind);
  EXPECT_TRUE(reportOf(id).blends_lost.empty());
}

/// With plans that are made beside the core.
class LoadPathPlannedBeside : public ::testing::Test {
 protected:
  LoadPathPlannedBeside() : cell("tm5-900", {}, {}, 250ms) { cell.connect(); }
  [[nodiscard]] double joint1() { return radToDeg(cell.robot().joints[0]); }
  CoreAndRobot cell;
};

TEST_F(LoadPathPlannedBeside, goesOnBehindARateThatIsAskedForAgain) {
  const GoalId id = cell.submit(turns(8, false));
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 4; }));
  cell.setFeedrate(50);
  cell.setFeedrate(100);
  cell.pass(300ms);
  cell.setFeedrate(50);
  EXPECT_TRUE(cell.passUntil([&] { return cell.outcome(id) != nullptr; }, 1min));
}

TEST_F(LoadPathPlannedBeside, letsAGoalBeTakenOutWhileTheRestIsPlanned) {
  const GoalId id = cell.submit(turns(2, true));
  const GoalId behind = cell.submit(turns(2, false, 2));
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 1; }));
  cell.setFeedrate(50, true);
  ASSERT_TRUE(
      cell.passUntil([&] { return cell.progress(id).back().text == "is planned at another feedrate"; }));
  cell.cancel(behind);
  cell.pass(1ms);
  EXPECT_EQ(cell.endOf(behind).ending, Ending::CommandAborted);
  EXPECT_EQ(cell.endOf(id).ending, Ending::Done);
  EXPECT_NEAR(joint1(), 6, 0.01);
}

TEST_F(LoadPathPlannedBeside, refusesWhatIsTooFastWhileTheRestIsPlanned) {
  const GoalId id = cell.submit(nearlyTooFast(turns(1, false, 29)));
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 30; }));
  cell.setFeedrate(50, true);
  ASSERT_TRUE(
      cell.passUntil([&] { return cell.progress(id).back().text == "is planned at another feedrate"; }));
  EXPECT_EQ(cell.setFeedrate(110)->error_id, own_error::kJointSpeed);
  EXPECT_EQ(cell.endOf(id).ending, Ending::Done);
}

TEST_F(LoadPathRestart, withNothingUnderWayIsAnOtherFeedrate) {
  EXPECT_TRUE(cell.setFeedrate(50, true)->success);
  const GoalId id = cell.submit(quarterTurn());
  expectDone(id);
  EXPECT_NEAR(toSeconds(*cell.endOf(id).planned), 3.0, 1e-3);
}

}  // namespace
}  // namespace cobot_command::testing
