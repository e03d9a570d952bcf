// Ranges of blended motions, and of a corner whenever the next motion comes.
#include "motion_support.h"
#include "random_motions.h"
#include <gtest/gtest.h>

#include "cobot_command/motion/blend.h"

namespace cobot_command::motion {
namespace {

TrajectoryPtr ptp(const arm::JointVector& from, const arm::JointVector& by) {
  return planned(plan(model(), from, Ptp{arm::JointVector(from + by), 0.5, milliseconds(200)}, {}));
}

class CornerOfPtps : public ::testing::Test {
 protected:
  [[nodiscard]] Corner corner() const { return {*before, *next}; }

  arm::JointVector at = workingPosture() + degrees(45, 0, 0, 0, 0, 0);
  TrajectoryPtr before = ptp(workingPosture(), degrees(45, 0, 0, 0, 0, 0));
  TrajectoryPtr next = ptp(at, degrees(0, 0, 0, 0, 0, 45));
};

TEST_F(CornerOfPtps, addsUpTheRangesOfBothLessTheCorner) {
  const Duration overlap = overlapAt(model(), corner(), BlendShare{1.0});
  ASSERT_EQ(overlap, Duration(milliseconds(200)));
  const auto motion = blended(before, next, overlap);
  const arm::JointVector first = before->at(before->duration() - overlap).position;
  const arm::JointVector last = next->at(overlap).position;
  const auto in_the_corner = motion->jointRange(Duration::zero(), overlap);
  ASSERT_TRUE(in_the_corner);
  EXPECT_LT((in_the_corner->lower - first).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((in_the_corner->upper - last).cwiseAbs().maxCoeff(), 1e-8);
  const auto whole = motion->jointRange(Duration::zero(), motion->duration());
  ASSERT_TRUE(whole);
  EXPECT_LT((whole->lower - first).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((whole->upper - next->end().position).cwiseAbs().maxCoeff(), 1e-8);
}

TEST_F(CornerOfPtps, isThatOfTheNextMotionAloneBehindIt) {
  const auto motion = blended(before, next, milliseconds(200));
  const auto one = motion->jointRange(milliseconds(250), milliseconds(400));
  const auto other = next->jointRange(milliseconds(250), milliseconds(400));
  ASSERT_TRUE(one && other);
  EXPECT_LT((one->lower - other->lower).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((one->upper - other->upper).cwiseAbs().maxCoeff(), 1e-8);
}

TEST_F(CornerOfPtps, hasALongestOverlapOfWhichAnyOtherIsAPart) {
  EXPECT_EQ(longestOverlap(model(), corner(), BlendShare{1.0}), Duration(milliseconds(200)));
  EXPECT_EQ(longestOverlap(model(), corner(), BlendShare{0.5}), Duration(milliseconds(100)));
  EXPECT_EQ(longestOverlap(model(), corner(), BlendShare{0.0}), Duration::zero());
  EXPECT_EQ(longestOverlap(model(), corner(), BlendRadius{0.0}), Duration::zero());
  EXPECT_EQ(longestOverlap(model(), corner(), BlendRadius{10.0}), Duration(milliseconds(200)));
  const BlendWay way{0.01, 0.01};
  EXPECT_EQ(longestOverlap(model(), corner(), way), overlapAt(model(), corner(), way));
  EXPECT_LT(longestOverlap(model(), corner(), way), milliseconds(200));
}

TEST_F(CornerOfPtps, hasALongestOverlapThatIsNotShortenedForTheArm) {
  // J1 would leave its limits in the corner.
  const arm::JointVector limit = workingPosture() + degrees(259.9, 0, 0, 0, 0, 0);
  const arm::JointVector away = degrees(40, 0, 0, 0, 0, 0);
  const auto to_limit = planned(plan(model(), limit - away, Ptp{limit, 1.0, milliseconds(200)}, {}));
  const auto off_limit = planned(plan(
      model(), limit, Ptp{arm::JointVector(limit + degrees(0, 20, 0, 0, 0, 0)), 1.0, milliseconds(200)}, {}));
  const Corner pair{*to_limit, *off_limit};
  EXPECT_GE(longestOverlap(model(), pair, BlendShare{1.0}), overlapAt(model(), pair, BlendShare{1.0}));
}

/// Wherever both are in a corner of any two motions, for any overlap up to the longest one.
TEST(CornerRange, containsTheArmWheneverTheNextMotionComes) {
  Dice dice(5);
  const arm::ArmModel arm = model();
  for (int i = 0; i < 100; ++i) {
    const auto before = ptp(workingPosture() + dice.joints(0.2), dice.joints(0.4));
    const auto next = ptp(before->end().position, dice.joints(0.4));
    const Duration longest = longestOverlap(arm, {*before, *next}, BlendShare{dice.between(0.3, 1.0)});
    const Duration end = before->duration();
    const auto range = cornerRange(*before, {end - longest, end}, *next, {Duration::zero(), longest});
    ASSERT_TRUE(range) << range.error().message;
    for (int share = 0; share <= 10; ++share) {
      const Duration overlap = longest / 10 * share;
      for (Duration time = overlap - longest; time <= longest; time += longest / 20) {
        const JointState state = time < Duration::zero() ? before->at(end - overlap + time)
                                                         : stateIn(*before, *next, overlap, time);
        EXPECT_TRUE(range->contains(state.position));
      }
    }
  }
}

TEST(CornerRange, canBeCutIntoPartsOfBoth) {
  const auto before = ptp(workingPosture(), degrees(30, -5, 0, 10, 0, 0));
  const auto next = ptp(before->end().position, degrees(0, 5, 10, -10, 0, 30));
  const Duration longest = longestOverlap(model(), {*before, *next}, BlendShare{1.0});
  const Duration begin = before->duration() - longest;
  constexpr int kParts = 8;
  const auto part = [&](int i) { return Interval{longest * i / kParts, longest * (i + 1) / kParts}; };
  for (int share = 0; share <= 10; ++share) {
    const Duration overlap = longest / 10 * share;
    for (Duration time{}; time < overlap; time += longest / 100) {
      const Duration before_time = longest - overlap + time;  // since the longest one would have begun
      const auto i = static_cast<int>(before_time * kParts / longest);
      const auto j = static_cast<int>(time * kParts / longest);
      EXPECT_LE(j, i) << "the next one is never farther";
      const auto range = cornerRange(*before, {begin + part(i).from, begin + part(i).to}, *next, part(j));
      ASSERT_TRUE(range);
      EXPECT_TRUE(range->contains(stateIn(*before, *next, overlap, time).position));
    }
  }
}

/// Says nothing of its ranges.
class Unknown final : public Trajectory {
 public:
  [[nodiscard]] Duration duration() const override { return milliseconds(400); }
  [[nodiscard]] Duration timeUp() const override { return milliseconds(200); }
  [[nodiscard]] Duration timeDown() const override { return milliseconds(200); }
  [[nodiscard]] JointState at(Duration /*time*/) const override {
    return {workingPosture(), arm::JointVector::Zero()};
  }
};

TEST(CornerRange, isRefusedWhereOneOfBothHasNone) {
  const auto unknown = std::make_shared<const Unknown>();
  const auto known = ptp(workingPosture(), degrees(30, 0, 0, 0, 0, 0));
  const Interval first{Duration::zero(), milliseconds(10)};
  EXPECT_FALSE(cornerRange(*unknown, first, *known, first));
  EXPECT_FALSE(cornerRange(*known, first, *unknown, first));
  const auto motion = blended(unknown, known, milliseconds(100));
  EXPECT_FALSE(motion->jointRange(Duration::zero(), milliseconds(200)));
  EXPECT_TRUE(motion->jointRange(milliseconds(100), milliseconds(200)));
}

}  // namespace
}  // namespace cobot_command::motion
