// Software limits: between which angles every motion is planned.
#include <limits>

#include "../load_path/path_goals.h"
#include "dynamics_cell.h"

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using command::SoftwareLimits;
using ::testing::HasSubstr;

class SoftwareLimitsOfTheArm : public DynamicsCell {
 protected:
  static SoftwareLimits ofModel() {
    SoftwareLimits limits;
    const auto arm = *arm::ArmModel::named("tm5-900");
    for (std::size_t i = 0; i < arm::kJointCount; ++i) {
      limits.lower[static_cast<Eigen::Index>(i)] = arm.limits()[i].lower;
      limits.upper[static_cast<Eigen::Index>(i)] = arm.limits()[i].upper;
    }
    return limits;
  }
  static SoftwareLimits ofJoint1(double lower, double upper) {
    SoftwareLimits limits = ofModel();
    limits.lower[0] = degToRad(lower);
    limits.upper[0] = degToRad(upper);
    return limits;
  }
  void limitJoint1() {
    const auto answer = cell.writeLimits(ofJoint1(-45, 60));
    ASSERT_TRUE(answer.success) << answer.message;
  }
  [[nodiscard]] int errorOf(const Goal& goal) { return cell.endOf(cell.submit(goal)).error_id; }
};

TEST_F(SoftwareLimitsOfTheArm, ruleForMoves) {
  limitJoint1();
  EXPECT_EQ(errorOf(turnTo(61)), own_error::kJointLimit);
  EXPECT_EQ(errorOf(turnTo(-46)), own_error::kJointLimit);
  expectDone(cell.submit(turnTo(60)));
  MoveAbsoluteGoal check = turnTo(61);
  check.check_only = true;
  EXPECT_EQ(errorOf(check), own_error::kJointLimit);
}

TEST_F(SoftwareLimitsOfTheArm, ruleForAMoveThatWaits) {
  limitJoint1();
  const GoalId first = cell.submit(turnTo(30));
  EXPECT_EQ(errorOf(turnTo(61)), own_error::kJointLimit) << "as it comes";
  expectDone(first);
}

TEST_F(SoftwareLimitsOfTheArm, ruleForLinesAndPoses) {
  limitJoint1();
  MoveRelativeGoal turn;
  turn.movement_command = static_cast<int>(Movement::Ptp);
  turn.data_format = static_cast<int>(RelativeFormat::Jpp);
  turn.target = {61, 0, 0, 0, 0, 0};
  turn.speed = 50;
  turn.accel_time = 200;
  EXPECT_EQ(errorOf(turn), own_error::kJointLimit);
}

TEST_F(SoftwareLimitsOfTheArm, ruleForChecksAndCycles) {
  limitJoint1();
  CheckSequenceGoal sequence;
  sequence.steps = {turnTo(30), turnTo(61)};
  EXPECT_EQ(errorOf(sequence), own_error::kStepRefused);
  PickAndPlaceGoal cycle;
  cycle.steps.resize(2);
  cycle.steps[0].move = turnTo(30);
  cycle.steps[1].move = turnTo(61);
  for (PickAndPlaceStep& step : cycle.steps) step.move.buffer_mode = 0;
  EXPECT_EQ(errorOf(cycle), own_error::kStepRefused);
}

TEST_F(SoftwareLimitsOfTheArm, ruleForPaths) {
  limitJoint1();
  LoadPathGoal path;
  path.path = {pathPoint({61, 0, 90, 0, 90, 0})};
  path.number_of_moves = 1;
  EXPECT_NE(errorOf(path), 0);
  EXPECT_THAT(cell.endOf(cell.submit(path)).error_description, HasSubstr("J1"));
}

TEST_F(SoftwareLimitsOfTheArm, ruleForTrajectories) {
  limitJoint1();
  FollowJointTrajectoryGoal goal;
  goal.buffer_mode = static_cast<int>(BufferMode::Aborting);
  TrajectoryPoint point;
  point.positions = {degToRad(61), 0, degToRad(90), 0, degToRad(90), 0};
  point.time = 3;
  goal.points = {point};
  EXPECT_EQ(errorOf(goal), own_error::kJointLimit);
}

TEST_F(SoftwareLimitsOfTheArm, areWidenedAgain) {
  limitJoint1();
  EXPECT_TRUE(cell.writeLimits(ofModel()).success);
  expectDone(cell.submit(turnTo(61)));
}

TEST_F(SoftwareLimitsOfTheArm, areRefusedWhenTheyCannotBe) {
  limitJoint1();
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [lower, upper] :
       {std::pair{10.0, 10.0}, {20.0, 10.0}, {-271.0, 60.0}, {-45.0, 271.0}, {none, 60.0}, {-45.0, none}}) {
    const auto answer = cell.writeLimits(ofJoint1(lower, upper));
    EXPECT_FALSE(answer.success);
    EXPECT_EQ(answer.error_id, 0x8D15);
    EXPECT_THAT(answer.message, HasSubstr("the limits of J1 are"));
  }
  EXPECT_EQ(errorOf(turnTo(61)), own_error::kJointLimit) << "the ones before rule on";
}

TEST_F(SoftwareLimitsOfTheArm, areRefusedWhileAGoalIsUnderWayOrWaits) {
  const GoalId move = cell.submit(turnTo(30));
  cell.pass(200ms);
  EXPECT_EQ(cell.writeLimits(ofJoint1(-45, 60)).error_id, 0x8C53);
  expectDone(move);
  cell.pass(200ms);
  EXPECT_TRUE(cell.writeLimits(ofJoint1(-45, 60)).success);
  cell.setSpeedOverride(0);
  cell.submit(turnTo(20));
  EXPECT_EQ(cell.writeLimits(ofJoint1(-45, 70)).error_id, 0x8C53);
}

TEST_F(SoftwareLimitsOfTheArm, areRefusedWhereTheRobotStandsOutside) {
  const auto answer = cell.writeLimits(ofJoint1(10, 60));
  EXPECT_EQ(answer.error_id, 0x8C54);
  EXPECT_THAT(answer.message, HasSubstr("J1 is at 0.000 deg"));
  expectDone(cell.submit(turnTo(61)));
}

TEST_F(SoftwareLimitsOfTheArm, holdOverALostLink) {
  limitJoint1();
  cell.dropConnections();
  cell.pass(100ms);
  cell.connect();
  EXPECT_EQ(errorOf(turnTo(61)), own_error::kJointLimit);
}

}  // namespace
}  // namespace cobot_command::testing
