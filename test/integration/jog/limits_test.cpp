// Before limits and singularities the arm stands, says why, and can be jogged away again.

#include <tuple>

#include "jog_cell.h"
#include <gmock/gmock.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

const arm::ArmModel& model() {
  static const arm::ArmModel kModel = *arm::ArmModel::named("tm5-900");
  return kModel;
}

/// A licence, the joint, the direction.
class JogLimits : public ::testing::TestWithParam<std::tuple<bool, int, int>> {};

TEST_P(JogLimits, letAJointStandBeforeItsEnd) {
  const auto [licence, joint, direction] = GetParam();
  JogCell cell(licence);
  const auto which = static_cast<std::size_t>(joint);
  const JogReport report = reportOf(cell.holdUntilItEnds(jog(JogMode::Axes, which, direction, 20)));
  EXPECT_EQ(report.ended_by, JogEnd::JointLimit) << report.why;
  EXPECT_EQ(report.joint, joint);
  EXPECT_THAT(report.why, HasSubstr("in the other direction"));
  const arm::JointLimit& limit = model().limits()[which];
  const double at = cell.jointDeg(joint);
  const double end = radToDeg(direction > 0 ? limit.upper : limit.lower);
  EXPECT_LE(direction * at, direction * end + 1e-6);
  const double speed = radToDeg(0.2 * limit.max_velocity);
  EXPECT_NEAR(at, end, licence ? 0.06 * speed : 0.01);
  EXPECT_TRUE(cell.stands());
  // Away from there.
  const GoalId back = cell.cell.submit(jog(JogMode::Axes, which, -direction, 20));
  cell.hold(1s);
  EXPECT_EQ(cell.cell.outcome(back), nullptr) << cell.cell.outcome(back)->error_description;
  EXPECT_GT(direction * (at - cell.jointDeg(joint)), 5);
}

INSTANTIATE_TEST_SUITE_P(All, JogLimits,
                         ::testing::Combine(::testing::Bool(), ::testing::Range(0, 6),
                                            ::testing::Values(-1, 1)));

TEST(JogAtALimit, isRefusedTowardsItAndSaysWhichJoint) {
  JogCell cell(false);
  static_cast<void>(cell.holdUntilItEnds(jog(JogMode::Axes, 2, 1, 20)));
  const Outcome outcome = cell.cell.endOf(cell.cell.submit(jog(JogMode::Axes, 2, 1, 20)));
  EXPECT_EQ(outcome.ending, Ending::Rejected);
  EXPECT_EQ(outcome.error_id, own_error::kJointLimit);
  EXPECT_THAT(outcome.error_description, HasSubstr("J3"));
}

struct Place {
  const char* name;
  std::array<double, 6> from;
  JogMode mode;
  std::size_t which;
  int direction;
  double (*distance)(const arm::SingularityDistance&);
};

class JogSingularities : public ::testing::TestWithParam<std::tuple<bool, Place>> {};

TEST_P(JogSingularities, letTheArmStandBeforeThem) {
  const auto [licence, place] = GetParam();
  JogCell cell(licence);
  cell.moveTo(place.from);
  const JogReport report = reportOf(cell.holdUntilItEnds(jog(place.mode, place.which, place.direction, 10)));
  EXPECT_TRUE(report.ended_by == JogEnd::Singularity || report.ended_by == JogEnd::JointSpeed ||
              report.ended_by == JogEnd::Reach)
      << static_cast<int>(report.ended_by) << " " << report.why;
  EXPECT_THAT(report.why, HasSubstr(place.name));
  EXPECT_TRUE(cell.stands());
  EXPECT_FALSE(cell.cell.robot().error) << "the controller had to stop it";
  const double before = place.distance(arm::singularityDistance(model(), cell.cell.robot().joints));
  EXPECT_GT(before, 0);
  const GoalId back = cell.cell.submit(jog(place.mode, place.which, -place.direction, 10));
  cell.hold(1s);
  EXPECT_EQ(cell.cell.outcome(back), nullptr) << cell.cell.outcome(back)->error_description;
  EXPECT_GT(place.distance(arm::singularityDistance(model(), cell.cell.robot().joints)), before);
}

double wristOf(const arm::SingularityDistance& distance) {
  return distance.wrist;
}
double elbowOf(const arm::SingularityDistance& distance) {
  return distance.elbow;
}
double shoulderOf(const arm::SingularityDistance& distance) {
  return std::abs(distance.shoulder);
}

const Place kWrist{"wrist", {0, 0, 90, 0, 40, 0}, JogMode::Tool, 4, 1, wristOf};
const Place kWrist2{"wrist", {0, 0, 90, 0, 40, 0}, JogMode::Tool, 4, -1, wristOf};
const Place kElbow{"elbow", {0, 20, 70, 0, 90, 0}, JogMode::Frame, 0, 1, elbowOf};
const Place kShoulder{"shoulder", {0, -20, 130, -20, 90, 0}, JogMode::Frame, 0, -1, shoulderOf};

INSTANTIATE_TEST_SUITE_P(All, JogSingularities,
                         ::testing::Combine(::testing::Bool(),
                                            ::testing::Values(kWrist, kWrist2, kElbow, kShoulder)));

}  // namespace
}  // namespace cobot_command::testing
