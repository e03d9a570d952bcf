// Promises of jointRange() that must hold of any motion: at random, and many times.
#include <algorithm>
#include <string>
#include <vector>

#include "random_motions.h"
#include "thorough.h"
#include <gtest/gtest.h>

#include "cobot_command/common/time.h"

namespace cobot_command::motion {
namespace {

using testing::fromEnvironment;
using testing::quickOrThorough;

/// What the joints really do in an interval, as far as it is looked at.
struct Seen {
  JointRange range;
  double fastest = 0.0;  ///< of any joint [rad/s]
  int outside = 0;       ///< of the range that was promised
  int outside_half = 0;  ///< of one about its centre, half as wide
};

Seen lookAt(const Trajectory& motion, Duration from, Duration to, const JointRange& promised) {
  constexpr int kTimes = 100;
  const arm::JointVector centre = promised.centre();
  const JointRange half{centre - 0.25 * promised.widths(), centre + 0.25 * promised.widths()};
  Seen seen{JointRange::of(motion.at(from).position)};
  for (int i = 0; i <= kTimes; ++i) {
    const JointState state = motion.at(from + (to - from) / kTimes * i);
    seen.range.include(state.position);
    seen.fastest = std::max(seen.fastest, state.velocity.cwiseAbs().maxCoeff());
    seen.outside += promised.contains(state.position) ? 0 : 1;
    seen.outside_half += half.contains(state.position) ? 0 : 1;
  }
  return seen;
}

class AnyInterval : public ::testing::TestWithParam<std::size_t> {
 protected:
  /// Calls `look` with a motion, an interval and the range that was promised.
  template <class Look>
  void forEach(int count, const Look& look) {
    constexpr int kIntervals = 8;  // of each motion
    constexpr const char* kModels[] = {"tm5-700", "tm5-900", "tm12", "tm14"};
    const MotionKind& kind = motionKinds()[GetParam()];
    Dice dice(fromEnvironment("COBOT_TEST_SEED", 1));
    for (int i = 0, thrown = 0; i < count; ++thrown) {
      ASSERT_LT(thrown, 100 * count) << "can hardly be made";
      const TrajectoryPtr motion = kind.make(*arm::ArmModel::named(kModels[thrown % 4]), dice);
      for (int k = 0; motion && k < kIntervals; ++k, ++i) {
        const double whole = toSeconds(motion->duration());
        const double length = whole * dice.ofAnySize(1e-4, 1.0);
        const Duration from = fromSeconds(dice.between(-0.01 * whole, 1.01 * whole - length));
        const Duration to = from + fromSeconds(length);
        const auto range = motion->jointRange(from, to);
        ASSERT_TRUE(range) << range.error().message;
        look(*motion, from, to, *range);
      }
    }
  }
};

/// Altogether 2000, and 10^5 where it is thorough.
int intervalsOfAKind() {
  const auto kinds = static_cast<int>(motionKinds().size());
  return quickOrThorough(2000, 100000) / kinds + 1;
}

TEST_P(AnyInterval, hasARangeThatNoJointLeaves) {
  int outside_half = 0;
  forEach(intervalsOfAKind(),
          [&](const Trajectory& motion, Duration from, Duration to, const JointRange& range) {
            const Seen seen = lookAt(motion, from, to, range);
            EXPECT_EQ(seen.outside, 0) << toSeconds(from) << " to " << toSeconds(to) << " s";
            outside_half += seen.outside_half;
          });
  EXPECT_GT(outside_half, 0) << "the test cannot fail";
}

TEST_P(AnyInterval, hasARangeAtMostThreeTimesAsWideAsItsWay) {
  constexpr double kStill = 3e-6;  // [rad], where next to nothing moves
  forEach(intervalsOfAKind(),
          [&](const Trajectory& motion, Duration from, Duration to, const JointRange& range) {
            const Seen seen = lookAt(motion, from, to, range);
            if (seen.fastest > 1.0) return;
            EXPECT_LE(range.widths().maxCoeff(), 3.0 * seen.range.widths().maxCoeff() + kStill)
                << toSeconds(from) << " to " << toSeconds(to) << " s";
          });
}

std::vector<std::size_t> allKinds() {
  std::vector<std::size_t> all(motionKinds().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

INSTANTIATE_TEST_SUITE_P(Kinds, AnyInterval, ::testing::ValuesIn(allKinds()),
                         [](const auto& kind) { return std::string(motionKinds()[kind.param].name); });

}  // namespace
}  // namespace cobot_command::motion
