// What jointRange() says of each kind of motion whose joints are known without it.
#include "cobot_command/motion/joint_range.h"

#include <vector>

#include "motion_support.h"

#include "cobot_command/motion/velocity.h"

namespace cobot_command::motion {
namespace {

/// The proved part of it, without the room for rounding.
JointRange rangeOf(const Trajectory& motion, Duration from, Duration to) {
  auto range = motion.jointRange(from, to);
  if (!range) {
    ADD_FAILURE() << range.error().message;
    return JointRange::of(arm::JointVector::Constant(NAN));
  }
  range->lower.array() += kRangeRoom;
  range->upper.array() -= kRangeRoom;
  return *range;
}

void expectRange(const JointRange& range, const arm::JointVector& lower, const arm::JointVector& upper,
                 double within = 1e-9) {
  EXPECT_LT((range.lower - lower).cwiseAbs().maxCoeff(), within) << range.lower.transpose();
  EXPECT_LT((range.upper - upper).cwiseAbs().maxCoeff(), within) << range.upper.transpose();
}

TEST(JointRangeOfPtp, isBetweenWhereTheJointsAreAtBothEnds) {
  const arm::JointVector target = workingPosture() + degrees(20, -10, 0, 5, 0, -40);
  const auto motion = planned(plan(model(), workingPosture(), Ptp{target, 0.5, milliseconds(100)}, {}));
  expectRange(rangeOf(*motion, Duration::zero(), motion->duration() / 2),
              workingPosture() + degrees(0, -5, 0, 0, 0, -20),
              workingPosture() + degrees(10, 0, 0, 2.5, 0, 0));
  expectRange(rangeOf(*motion, Duration::zero(), motion->duration()),
              workingPosture() + degrees(0, -10, 0, 0, 0, -40),
              workingPosture() + degrees(20, 0, 0, 5, 0, 0));
}

TEST(JointRange, isThePostureAtOneMomentAndAtRest) {
  const arm::JointVector target = workingPosture() + degrees(20, 0, 0, 0, 0, 0);
  const auto motion = planned(plan(model(), workingPosture(), Ptp{target, 0.5, milliseconds(100)}, {}));
  const Duration end = motion->duration();
  expectRange(rangeOf(*motion, milliseconds(100), milliseconds(100)), motion->at(milliseconds(100)).position,
              motion->at(milliseconds(100)).position);
  expectRange(rangeOf(*motion, -milliseconds(9), Duration::zero()), workingPosture(), workingPosture());
  expectRange(rangeOf(*motion, end, end + milliseconds(9000)), target, target);
  const auto stays =
      planned(plan(model(), workingPosture(), Ptp{workingPosture(), 0.5, milliseconds(1)}, {}));
  expectRange(rangeOf(*stays, Duration::zero(), milliseconds(1)), workingPosture(), workingPosture());
}

TEST(JointRange, clampsTimesAndTakesThemInEitherOrder) {
  const arm::JointVector target = workingPosture() + degrees(20, 0, 0, 0, 0, 0);
  const auto motion = planned(plan(model(), workingPosture(), Ptp{target, 0.5, milliseconds(100)}, {}));
  const Duration middle = motion->duration() / 2;
  const JointRange first = rangeOf(*motion, -milliseconds(100), middle);
  expectRange(first, workingPosture(), workingPosture() + degrees(10, 0, 0, 0, 0, 0));
  expectRange(rangeOf(*motion, middle, -milliseconds(100)), first.lower, first.upper, 1e-15);
  expectRange(rangeOf(*motion, 10 * motion->duration(), middle),
              workingPosture() + degrees(10, 0, 0, 0, 0, 0), target);
}

TEST(JointRange, leavesRoomForRoundingAndNoMore) {
  const auto stays =
      planned(plan(model(), workingPosture(), Ptp{workingPosture(), 0.5, milliseconds(1)}, {}));
  const auto range = stays->jointRange(Duration::zero(), Duration::zero());
  ASSERT_TRUE(range);
  EXPECT_LT((range->widths() - arm::JointVector::Constant(2.0 * kRangeRoom)).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_TRUE(range->contains(workingPosture()));
  EXPECT_FALSE(range->contains(workingPosture() + degrees(0, 0, 1e-6, 0, 0, 0)));
}

TEST(JointRangeOfAPvt, reachesWhereAJointTurnsRoundBetweenThePoints) {
  // x(t) = t (1 - t) v from 0 to 0 with the slopes v and -v: highest in the middle, v / 4.
  const arm::JointVector rest = arm::JointVector::Zero();
  const arm::JointVector fast = degrees(20, 0, 0, 0, 0, 0);
  const std::vector<PvtJointPoint> points{
      {workingPosture(), fast, 1.0}, {workingPosture(), -fast, 1.0}, {workingPosture(), rest, 1.0}};
  const auto motion = planned(plan(model(), workingPosture(), Pvt{points}, {}));
  const arm::JointVector peak = workingPosture() + degrees(5, 0, 0, 0, 0, 0);
  expectRange(rangeOf(*motion, milliseconds(1000), milliseconds(2000)), workingPosture(), peak);
  expectRange(rangeOf(*motion, milliseconds(1400), milliseconds(1600)),
              workingPosture() + degrees(20 * 0.24, 0, 0, 0, 0, 0), peak);
  expectRange(rangeOf(*motion, milliseconds(1100), milliseconds(1200)),
              workingPosture() + degrees(20 * 0.09, 0, 0, 0, 0, 0),
              workingPosture() + degrees(20 * 0.16, 0, 0, 0, 0, 0));
  // Before and behind it: t^3 - t^2 of v goes to -4/27 of v at 2/3 of the time, and likewise backwards.
  expectRange(rangeOf(*motion, Duration::zero(), motion->duration()),
              workingPosture() - degrees(20 * 4.0 / 27.0, 0, 0, 0, 0, 0), peak);
}

TEST(JointRangeOfAJointVelocity, reachesWhereAJointTurnsRoundInTheRamp) {
  // From -10 deg/s to 10 deg/s in 0.4 s: turns round at 0.2 s, 1 deg behind where it was.
  SetVelocity set;
  set.velocity = degrees(10, 0, 0, 0, 0, 0);
  set.ramp = milliseconds(400);
  set.lasting = milliseconds(1400);
  const JointState now{workingPosture(), degrees(-10, 0, 0, 0, 0, 0)};
  const auto made = planVelocity(model(), now, set, {});
  ASSERT_TRUE(made) << made.error().message;
  const Trajectory& motion = *made->trajectory;
  const arm::JointVector lowest = workingPosture() - degrees(1, 0, 0, 0, 0, 0);
  expectRange(rangeOf(motion, Duration::zero(), milliseconds(400)), lowest, workingPosture());
  expectRange(rangeOf(motion, Duration::zero(), milliseconds(1400)), lowest,
              workingPosture() + degrees(10, 0, 0, 0, 0, 0));
  expectRange(rangeOf(motion, Duration::zero(), motion.duration()), lowest,
              workingPosture() + degrees(12, 0, 0, 0, 0, 0));
  expectRange(rangeOf(motion, milliseconds(300), milliseconds(400)),
              workingPosture() - degrees(0.75, 0, 0, 0, 0, 0), workingPosture());
}

/// Of the TCP about the axis of J1, turning with it: J1 moves, and no other joint.
TEST(JointRangeOfAPath, isThatOfJ1OnAnArcAboutItsAxis) {
  const arm::Pose start = tcpAt(model(), workingPosture(), {});
  const auto about = [&](double angle) {
    return arm::Pose(Eigen::AngleAxisd(degToRad(angle), Eigen::Vector3d::UnitZ()) * start);
  };
  const Circle arc{about(20), about(60), std::nullopt, TcpSpeed{0.2}, milliseconds(200)};
  const auto motion = planned(plan(model(), workingPosture(), arc, {}));
  const auto at = [&](Duration time) -> arm::JointVector {
    return workingPosture() + degrees(60.0 * motion->progress(time), 0, 0, 0, 0, 0);
  };
  for (const int length : {1, 10, 100}) {
    const Duration from = milliseconds(700);
    const Duration to = from + milliseconds(length);
    const double way = 60.0 * (motion->progress(to) - motion->progress(from));
    expectRange(rangeOf(*motion, from, to), at(from), at(to), 0.2 * degToRad(way));
  }
  // Shorter pieces are closer: the excess falls with the square of the length.
  const Duration from = milliseconds(700);
  const Duration to = from + milliseconds(1);
  expectRange(rangeOf(*motion, from, to), at(from), at(to), 1e-5);
  expectRange(rangeOf(*motion, Duration::zero(), motion->duration()), workingPosture(),
              at(motion->duration()), 0.02);
}

TEST(JointRangeOfAWristMove, isThatOfJ4ToJ6OnTheirWay) {
  // They are in step with the way, and closer than any other joint.
  const arm::JointVector target = workingPosture() + degrees(0, 3, -6, 30, -170, 90);
  const PathRates rates{{0.1, 1.0, 1.0}, {1.0, 5.0, 5.0}, {}};
  const auto motion = planned(plan(model(), workingPosture(), WristMove{target, rates}, {}));
  const JointRange range = rangeOf(*motion, Duration::zero(), motion->duration());
  const arm::JointVector lower = workingPosture().cwiseMin(target);
  const arm::JointVector upper = workingPosture().cwiseMax(target);
  for (const Eigen::Index joint : {3, 4, 5}) {
    EXPECT_NEAR(range.lower[joint], lower[joint], 0.02) << joint;
    EXPECT_NEAR(range.upper[joint], upper[joint], 0.02) << joint;
  }
}

/// Says where it is, and not how it gets from there to the next moment.
class Unknown final : public Trajectory {
 public:
  [[nodiscard]] Duration duration() const override { return milliseconds(400); }
  [[nodiscard]] Duration timeUp() const override { return {}; }
  [[nodiscard]] Duration timeDown() const override { return {}; }
  [[nodiscard]] JointState at(Duration /*time*/) const override {
    return {workingPosture(), arm::JointVector::Zero()};
  }
};

TEST(JointRange, isRefusedOfAMotionThatPromisesNone) {
  const auto range = Unknown().jointRange(milliseconds(100), milliseconds(200));
  ASSERT_FALSE(range);
  EXPECT_EQ(range.error().from, Duration(milliseconds(100)));
  EXPECT_EQ(range.error().to, Duration(milliseconds(200)));
  EXPECT_EQ(range.error().message,
            "UNBOUNDED: from 0.100000 s to 0.200000 s of the motion no range of the joints can be proved, "
            "because this kind of motion guarantees none: use one that is planned");
  EXPECT_TRUE(Unknown().jointRange(milliseconds(500), milliseconds(600))) << "it is at rest";
}

}  // namespace
}  // namespace cobot_command::motion
