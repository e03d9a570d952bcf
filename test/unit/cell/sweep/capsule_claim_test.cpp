#include "cobot_command/cell/sweep/capsule_claim.h"

#include <cmath>

#include "cell_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;

constexpr double kRounding = 1e-9;

/// Every voxel around the capsule against the distance of its cube.
void expectExactlyTheCubesWithinReach(const VoxelSet& set, const Capsule& grown, double edge) {
  const Vector3d beside = Vector3d::Constant(grown.radius + 2 * edge);
  const Voxel lower = voxelAt(grown.from.cwiseMin(grown.to) - beside, edge);
  const Voxel upper = voxelAt(grown.from.cwiseMax(grown.to) + beside, edge);
  std::size_t found = 0;
  for (std::int32_t x = lower[0]; x <= upper[0]; ++x) {
    for (std::int32_t y = lower[1]; y <= upper[1]; ++y) {
      for (std::int32_t z = lower[2]; z <= upper[2]; ++z) {
        const double distance = coreDistance(grown, cubeOf({x, y, z}, edge));
        const bool claimed = set.contains({x, y, z});
        if (claimed) ++found;
        ASSERT_TRUE(!claimed || distance <= grown.radius + kRounding) << x << " " << y << " " << z;
        ASSERT_TRUE(claimed || distance > grown.radius - kRounding) << x << " " << y << " " << z;
      }
    }
  }
  ASSERT_EQ(set.count(), found);
}

/// Any, and such as are along axes, in planes of the grid, points, next to points, and thin.
Capsule randomCapsule(RandomNumbers& random, int kind, double edge) {
  Capsule capsule{random.point(0.2), random.point(0.2), random.within(0.001, 0.1)};
  if (kind == 1) capsule.to = capsule.from;
  if (kind == 2) {
    capsule.to =
        capsule.from + random.within(-0.3, 0.3) * Vector3d::Unit(static_cast<int>(random.within(0, 3)));
  }
  if (kind == 3) capsule.to.y() = capsule.from.y();
  if (kind == 4) {
    const auto on_grid = [edge](const Vector3d& point) {
      return (edge * (point / edge).array().round()).matrix().eval();
    };
    capsule = {on_grid(capsule.from), on_grid(capsule.to), edge * std::round(capsule.radius / edge)};
  }
  if (kind == 5) capsule.radius = 0;
  if (kind == 6) capsule.to = capsule.from + 1e-9 * random.point(1);
  if (kind == 7) capsule.to = capsule.from + random.within(-0.2, 0.2) * Vector3d(1, 1, -1);
  return capsule;
}

TEST(CapsuleClaim, areExactlyTheCubesWithinReach) {
  RandomNumbers random(8);
  for (int i = 0; i < 800; ++i) {
    const double edge = i % 3 == 0 ? 0.02 : random.within(0.008, 0.06);
    const Capsule grown = randomCapsule(random, i % 8, edge);
    VoxelSet set;
    claimCapsule(set, grown, edge);
    SCOPED_TRACE(i);
    ASSERT_NO_FATAL_FAILURE(expectExactlyTheCubesWithinReach(set, grown, edge));
  }
}

TEST(CapsuleClaim, addsToWhatIsThere) {
  RandomNumbers random(9);
  VoxelSet both;
  VoxelSet apart;
  for (int i = 0; i < 20; ++i) {
    const Capsule grown = randomCapsule(random, 0, 0.02);
    claimCapsule(both, grown, 0.02);
    VoxelSet one;
    claimCapsule(one, grown, 0.02);
    apart |= one;
  }
  EXPECT_EQ(both, apart);
}

}  // namespace
}  // namespace cobot_command::cell
