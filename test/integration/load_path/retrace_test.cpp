// Back along a path that was driven, by the core and the simulated controller.
#include "cobot_command/blocks/ways_back/retrace.h"

#include "path_goals.h"
#include "way_distance.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

RetraceGoal back(int point = RetraceGoal::kStart, double speed = 100) {
  RetraceGoal goal;
  goal.point = point;
  goal.speed = speed;
  return goal;
}

/// The flange up, aside and down again, about blended corners, and then along.
LoadPathGoal overAnEdge() {
  LoadPathGoal goal;
  for (const arm::ControllerPose& pose : {arm::ControllerPose{517.5, -122.3, 521.05, 180, 0, 90},
                                          arm::ControllerPose{517.5, -22.3, 521.05, 180, 0, 90},
                                          arm::ControllerPose{517.5, -22.3, 461.05, 180, 0, 90},
                                          arm::ControllerPose{517.5, 77.7, 461.05, 180, 0, 90}}) {
    path::PathPoint point = pathLine(pose);
    point.termination_type = static_cast<int>(path::Termination::Blend);
    point.command_tolerance = 20;
    goal.path.push_back(point);
  }
  goal.path[2].termination_type = static_cast<int>(path::Termination::Stop);
  goal.number_of_moves = 4;
  return goal;
}

class Retracing : public LoadPathCell {
 protected:
  using Place = Eigen::Vector3d;
  [[nodiscard]] Place flange() {
    return mToMm(1) *
           arm::forwardKinematics(*arm::ArmModel::named("tm5-900"), cell.robot().joints).translation();
  }
  /// Where the flange is until that goal has ended, and every so often.
  std::vector<Place> watch(GoalId id) {
    std::vector<Place> places{flange()};
    while (cell.outcome(id) == nullptr) {
      cell.pass(4ms);
      places.push_back(flange());
    }
    return places;
  }
  void expectAt(const Place& place, double tolerance = 0.02) {
    EXPECT_LT((flange() - place).norm(), tolerance) << flange().transpose() << " [mm]";
  }
  void expectRejected(GoalId id, int error_id, const std::string& words = "") {
    const Outcome& outcome = cell.endOf(id);
    EXPECT_EQ(outcome.ending, Ending::Rejected);
    EXPECT_EQ(outcome.error_id, error_id) << outcome.error_description;
    EXPECT_THAT(outcome.error_description, HasSubstr(words));
  }
  const Place start{517.5, -122.3, 461.05};
};

TEST_F(Retracing, drivesTheWayThatWasDriven) {
  const auto way = watch(cell.submit(overAnEdge()));
  const GoalId id = cell.submit(back());
  const auto found = watch(id);
  expectDone(id);
  expectAt(start);
  EXPECT_LT(mostOff(found, way), 0.05) << "[mm] off the way";
  EXPECT_LT(mostOff(way, found), 0.05) << "[mm] left out";
}

TEST_F(Retracing, leadsOutOfWhereACancelHasStoppedThePath) {
  const GoalId path = cell.submit(overAnEdge());
  std::vector<Place> way;
  while (activeOf(path) < 2) {
    cell.pass(4ms);
    way.push_back(flange());
  }
  cell.cancel(path);
  const auto stopping = watch(path);
  way.insert(way.end(), stopping.begin(), stopping.end());
  EXPECT_EQ(cell.endOf(path).ending, Ending::CommandAborted);
  const GoalId id = cell.submit(back());
  EXPECT_LT(mostOff(watch(id), way), 0.05);
  expectDone(id);
  expectAt(start);
}

TEST_F(Retracing, goesToAPointAndOnFromThere) {
  cell.endOf(cell.submit(overAnEdge()));
  const Place end = flange();
  expectDone(cell.submit(back(2)));
  expectAt({517.5, -22.3, 461.05});
  expectDone(cell.submit(back(1)));
  const Place corner = flange();
  EXPECT_LT((corner - Place(517.5, -22.3, 521.05)).norm(), 20) << "the middle of the corner";
  EXPECT_GT((corner - Place(517.5, -22.3, 521.05)).norm(), 1);
  expectDone(cell.submit(back(2)));
  expectAt({517.5, -22.3, 461.05});
  expectDone(cell.submit(back(RetraceGoal::kEnd)));
  expectAt(end);
  expectDone(cell.submit(back(RetraceGoal::kEnd)));
  expectAt(end);
}

TEST_F(Retracing, isAsFastAsItIsToBe) {
  cell.endOf(cell.submit(turns(3, false)));
  const auto duration = [&](double speed) {
    const GoalId id = cell.submit(back(RetraceGoal::kStart, speed));
    const Duration planned = cell.endOf(id).planned.value();
    cell.endOf(cell.submit(back(RetraceGoal::kEnd)));
    return toSeconds(planned);
  };
  const double full = duration(100) - 0.5;
  EXPECT_NEAR(duration(50) - 0.5, full * 2, 0.01);
  EXPECT_NEAR(duration(0) - 0.5, full * 4, 0.01) << "25 %";
  cell.setSpeedOverride(50);
  EXPECT_NEAR(duration(50) - 0.5, full * 4, 0.01);
}

TEST_F(Retracing, crossesTheGoalsOfAChain) {
  const GoalId first = cell.submit(turns(3, true));
  const GoalId second = cell.submit(turns(3, false, 3));
  expectDone(first);
  expectDone(second);
  expectDone(cell.submit(back(0)));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 12, 0.01) << "of the last goal";
  expectDone(cell.submit(back()));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 9, 0.2) << "where that was set out for";
  RetraceGoal goal = back();
  goal.method_id = 1;
  expectDone(cell.submit(goal));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 0, 0.01);
  goal.method_id = 2;
  goal.point = 2;
  expectDone(cell.submit(goal));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 18, 0.01);
}

TEST_F(Retracing, knowsTheWayBehindARestart) {
  const GoalId path = cell.submit(overAnEdge());
  std::vector<Place> way;
  const auto note = [&](const std::function<bool()>& done) {
    while (!done()) {
      cell.pass(4ms);
      way.push_back(flange());
    }
  };
  note([&] { return activeOf(path) == 1; });
  cell.setFeedrate(60, true);
  note([&] { return activeOf(path) == 3; });
  cell.setFeedrate(100, true);
  note([&] { return cell.outcome(path) != nullptr; });
  expectDone(path);
  const GoalId id = cell.submit(back());
  EXPECT_LT(mostOff(watch(id), way), 0.05);
  expectDone(id);
  expectAt(start);
}

TEST_F(Retracing, ofAnInterruptedPathLetsItGoOnFromItsEnd) {
  const GoalId path = cell.submit(overAnEdge());
  passUntilActive(path, 2);
  ASSERT_TRUE(cell.passUntil([answer = cell.interrupt()] { return answer->has_value(); }));
  const Place interrupted = flange();
  expectDone(cell.submit(back(0)));
  EXPECT_EQ(cell.goOn().error_id, 0x8C02) << "it is not there";
  expectDone(cell.submit(back(RetraceGoal::kEnd)));
  expectAt(interrupted);
  EXPECT_TRUE(cell.goOn().success);
  expectDone(path);
  expectAt({517.5, 77.7, 461.05});
  expectDone(cell.submit(back()));
  expectAt(start);
}

TEST_F(Retracing, ofAScriptGoesByItsPoints) {
  LoadPathGoal goal = turns(4, false);
  goal.execution = static_cast<int>(Execution::Script);
  goal.allow_approximation = true;
  const GoalId path = cell.submit(goal);
  passUntilActive(path, 3);
  cell.cancel(path);
  cell.endOf(path);
  expectDone(cell.submit(back(1)));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 6, 0.01);
  expectDone(cell.submit(back()));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 0, 0.01);
}

TEST_F(Retracing, takesOver) {
  const GoalId path = cell.submit(overAnEdge());
  passUntilActive(path, 2);
  RetraceGoal goal = back();
  expectRejected(cell.submit(goal), motion_error::kOtherBlockBusy);
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  const GoalId id = cell.submit(goal);
  EXPECT_EQ(cell.endOf(path).ending, Ending::CommandAborted);
  expectDone(id);
  expectAt(start);
}

TEST_F(Retracing, takesOverFromAnotherOnItsWay) {
  cell.endOf(cell.submit(overAnEdge()));
  const Place end = flange();
  const GoalId first = cell.submit(back(RetraceGoal::kStart, 20));
  cell.pass(4s);
  RetraceGoal goal = back(RetraceGoal::kEnd);
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  const GoalId second = cell.submit(goal);
  EXPECT_EQ(cell.endOf(first).ending, Ending::CommandAborted);
  EXPECT_GT((flange() - end).norm(), 10);
  expectDone(second);
  expectAt(end);
}

TEST_F(Retracing, endsAnInterruptedPathThatItTakesOver) {
  const GoalId path = cell.submit(overAnEdge());
  passUntilActive(path, 2);
  ASSERT_TRUE(cell.passUntil([answer = cell.interrupt()] { return answer->has_value(); }));
  RetraceGoal goal = back();
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  expectDone(cell.submit(goal));
  EXPECT_EQ(cell.endOf(path).ending, Ending::CommandAborted);
  expectAt(start);
}

TEST_F(Retracing, waitsItsTurn) {
  const GoalId path = cell.submit(overAnEdge());
  RetraceGoal goal = back();
  goal.buffer_mode = static_cast<int>(BufferMode::Buffered);
  const GoalId id = cell.submit(goal);
  expectDone(path);
  expectDone(id);
  expectAt(start);
}

TEST_F(Retracing, isCancelledOnItsWayAndGoesOn) {
  cell.endOf(cell.submit(overAnEdge()));
  const GoalId id = cell.submit(back(RetraceGoal::kStart, 20));
  cell.pass(4s);
  cell.cancel(id);
  EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
  const Place between = flange();
  EXPECT_GT((between - start).norm(), 10);
  expectDone(cell.submit(back()));
  expectAt(start);
}

TEST_F(Retracing, isRefusedWithoutAWay) {
  expectRejected(cell.submit(back()), own_error::kNothingDriven);
  cell.endOf(cell.submit(turns(3, false)));
  expectRejected(cell.submit(back(3)), own_error::kPointNotDriven, "point 3 of load_path 1");
  expectRejected(cell.submit(back(3)), own_error::kPointNotDriven,
                 "allowed: 0..2, -1 (START), -2 (END) of load_path 1");
  RetraceGoal goal = back();
  goal.method_id = 7;
  expectRejected(cell.submit(goal), own_error::kPointNotDriven,
                 "allowed: -2 (END) of load_path 7; known are goals 1..1");
}

TEST_F(Retracing, isRefusedBesideTheWay) {
  cell.endOf(cell.submit(turns(3, false)));
  MoveAbsoluteGoal away = good<MoveAbsoluteGoal>();
  away.movement_command = 1;
  away.data_format = static_cast<int>(AbsoluteFormat::Jpp);
  away.target = {9, 0.2, 90, 0, 90, 0};
  expectDone(cell.submit(away));
  expectRejected(cell.submit(back()), own_error::kNotOnTheWay, "J2 is 0.20 deg off");
  away.target = {4, 0.05, 90, 0, 90, 0};
  expectDone(cell.submit(away));
  expectDone(cell.submit(back()));
  EXPECT_NEAR(radToDeg(cell.robot().joints[1]), 0, 1e-3);
  expectDone(cell.submit(back(RetraceGoal::kEnd)));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 9, 1e-3);
}

TEST_F(Retracing, isOfThePathThatHasMovedTheRobotLast) {
  cell.endOf(cell.submit(turns(3, false)));
  cell.setSpeedOverride(0);
  const GoalId path = cell.submit(turns(3, false, 3));
  cell.pass(2s);
  cell.cancel(path);  // before it has moved
  cell.endOf(path);
  cell.setSpeedOverride(100);
  expectDone(cell.submit(back()));
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 0, 1e-3);
}

TEST_F(Retracing, outlivesTheLinkToTheSameController) {
  const GoalId path = cell.submit(overAnEdge());
  passUntilActive(path, 2);
  cell.dropConnections();
  EXPECT_EQ(cell.endOf(path).ending, Ending::Aborted);
  cell.connect();
  cell.pass(2s);
  expectDone(cell.submit(back()));
  expectAt(start);
}

TEST_F(Retracing, isOfTheControllerThatHasDrivenThePath) {
  cell.endOf(cell.submit(turns(3, false)));
  constexpr GoalId kLink = 1;
  cell.cancel(kLink);
  cell.endOf(kLink);
  ConnectGoal other;
  other.host = "192.0.2.9";
  const GoalId link = cell.submit(other);
  cell.pass(2s);
  expectRejected(cell.submit(back()), own_error::kNothingDriven);
  cell.cancel(link);
  cell.endOf(link);
  cell.connect();
  cell.pass(1s);
  expectDone(cell.submit(back()));
}

/// To a point, down, and up to it again.
TEST_F(Retracing, doesNotGoDownAgainFromAPlaceThatWasPassedTwice) {
  LoadPathGoal goal;
  for (const double z : {521.05, 481.05, 521.05}) {
    goal.path.push_back(pathLine({517.5, -122.3, z, 180, 0, 90}));
  }
  goal.number_of_moves = 3;
  expectDone(cell.submit(goal));
  expectDone(cell.submit(back(0)));
  expectAt({517.5, -122.3, 521.05});
  for (const Place& place : watch(cell.submit(back()))) {
    EXPECT_LT(place.z(), 521.15);
    EXPECT_GT(place.z(), 461) << "[mm]";
  }
  expectAt(start);
  expectDone(cell.submit(back(0)));
  const GoalId id = cell.submit(back(RetraceGoal::kStart, 30));
  cell.pass(700ms);
  cell.cancel(id);
  cell.endOf(id);
  const double height = flange().z();
  EXPECT_LT(height, 521);
  for (const Place& place : watch(cell.submit(back()))) EXPECT_LT(place.z(), height + 0.1);
  expectAt(start);
}

TEST_F(Retracing, isHeldByAnOverrideOf0AndGoesOn) {
  cell.endOf(cell.submit(turns(3, false)));
  cell.setSpeedOverride(0);
  const GoalId id = cell.submit(back());
  cell.pass(10s);
  EXPECT_EQ(cell.outcome(id), nullptr);
  EXPECT_NEAR(radToDeg(cell.robot().joints[0]), 9, 1e-3);
  cell.setSpeedOverride(100);
  expectDone(id);
  const GoalId again = cell.submit(back(RetraceGoal::kEnd, 10));
  cell.pass(1s);
  cell.setSpeedOverride(0);
  cell.pass(10s);
  EXPECT_EQ(cell.outcome(again), nullptr);
  cell.setSpeedOverride(100);
  expectDone(again);
}

TEST_F(Retracing, cannotBeInterrupted) {
  cell.endOf(cell.submit(turns(3, false)));
  const GoalId id = cell.submit(back());
  cell.pass(300ms);
  const auto answer = cell.interrupt();
  ASSERT_TRUE(answer->has_value());
  EXPECT_EQ((*answer)->error_id, own_error::kInterruption);
  EXPECT_THAT((*answer)->message, HasSubstr("retrace cannot"));
  expectDone(id);
}

}  // namespace
}  // namespace cobot_command::testing
