#include "cobot_command/cell/sweep/voxel_set.h"

#include <algorithm>
#include <set>

#include "cell_test_support.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

using Plain = std::set<Voxel>;

Voxel randomVoxel(RandomNumbers& random, double size) {
  const auto coordinate = [&] { return static_cast<std::int32_t>(std::floor(random.within(-size, size))); };
  return {coordinate(), coordinate(), coordinate()};
}

Plain randomPlain(RandomNumbers& random, int count, double size) {
  Plain plain;
  for (int i = 0; i < count; ++i) plain.insert(randomVoxel(random, size));
  return plain;
}

VoxelSet setOf(const Plain& plain) {
  VoxelSet set;
  for (const Voxel& voxel : plain) set.insert(voxel);
  return set;
}

std::vector<Voxel> listOf(const Plain& plain) {
  return {plain.begin(), plain.end()};
}

bool touch(const Voxel& a, const Voxel& b) {
  return std::abs(a[0] - b[0]) <= 1 && std::abs(a[1] - b[1]) <= 1 && std::abs(a[2] - b[2]) <= 1;
}

/// Each with each, until nothing changes.
std::vector<Plain> plainComponents(Plain left) {
  std::vector<Plain> components;
  while (!left.empty()) {
    Plain component{*left.begin()};
    left.erase(left.begin());
    for (bool grown = true; grown;) {
      grown = false;
      for (auto voxel = left.begin(); voxel != left.end();) {
        const bool near = std::any_of(component.begin(), component.end(),
                                      [&](const Voxel& other) { return touch(*voxel, other); });
        if (near) component.insert(*voxel);
        voxel = near ? left.erase(voxel) : std::next(voxel);
        grown = grown || near;
      }
    }
    components.push_back(component);
  }
  return components;
}

TEST(VoxelSet, holdsWhatWasPutIn) {
  RandomNumbers random(10);
  const Plain plain = randomPlain(random, 3000, 30);
  VoxelSet set;
  for (const Voxel& voxel : plain) EXPECT_TRUE(set.insert(voxel));
  for (const Voxel& voxel : plain) EXPECT_FALSE(set.insert(voxel));
  EXPECT_EQ(set.count(), plain.size());
  EXPECT_EQ(set.sorted(), listOf(plain));
  EXPECT_EQ(set.lowest(), *plain.begin());
  EXPECT_FALSE(VoxelSet().lowest());
  for (int i = 0; i < 3000; ++i) {
    const Voxel voxel = randomVoxel(random, 40);
    EXPECT_EQ(set.contains(voxel), plain.count(voxel) == 1);
  }
}

TEST(VoxelSet, unitesIntersectsAndTakesAwayAsSetsDo) {
  RandomNumbers random(11);
  for (int i = 0; i < 60; ++i) {
    const Plain a = randomPlain(random, i % 7 == 0 ? 0 : 400, i % 2 == 0 ? 6 : 40);
    const Plain b = randomPlain(random, i % 5 == 0 ? 0 : 400, i % 2 == 0 ? 6 : 40);
    Plain both;
    Plain common;
    Plain rest;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(common, common.end()));
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(rest, rest.end()));
    const VoxelSet set_a = setOf(a);
    const VoxelSet set_b = setOf(b);
    EXPECT_EQ((set_a | set_b).sorted(), listOf(both));
    EXPECT_EQ((set_a & set_b).sorted(), listOf(common));
    EXPECT_EQ((set_a - set_b).sorted(), listOf(rest));
    EXPECT_EQ((set_a & set_b), setOf(common));
    EXPECT_EQ((set_a - set_b), setOf(rest));
    EXPECT_EQ(set_a.touches(set_b), !common.empty());
    EXPECT_EQ(set_a.countCommon(set_b), common.size());
    EXPECT_EQ(set_a == set_b, a == b);
    EXPECT_EQ((set_a - set_a).empty(), true);
  }
}

TEST(VoxelSet, withItselfIsItselfOrNothing) {
  RandomNumbers random(12);
  const Plain plain = randomPlain(random, 100, 10);
  VoxelSet set = setOf(plain);
  const VoxelSet& same = set;
  set |= same;
  set &= same;
  EXPECT_EQ(set.sorted(), listOf(plain));
  set -= same;
  EXPECT_TRUE(set.empty());
  EXPECT_FALSE(set.bounds());
  EXPECT_TRUE(set.insert({1, 2, 3}));
}

TEST(VoxelSet, hasTheSameBytesInWhateverOrderItWasFilled) {
  RandomNumbers random(13);
  const std::vector<Voxel> voxels = listOf(randomPlain(random, 1000, 40));
  VoxelSet forward;
  VoxelSet backward;
  for (auto voxel = voxels.begin(); voxel != voxels.end(); ++voxel) forward.insert(*voxel);
  for (auto voxel = voxels.rbegin(); voxel != voxels.rend(); ++voxel) backward.insert(*voxel);
  VoxelSet more = forward;
  for (int i = 0; i < 1000; ++i) more.insert(randomVoxel(random, 100));
  more &= forward;
  EXPECT_EQ(forward.bytes(), backward.bytes());
  EXPECT_EQ(forward.bytes(), more.bytes());
  EXPECT_EQ(forward, backward);
}

TEST(VoxelSet, comesBackFromItsBytesAndFromNoOthers) {
  RandomNumbers random(14);
  const VoxelSet set = setOf(randomPlain(random, 500, 40));
  const std::string bytes = set.bytes();
  const auto read = VoxelSet::fromBytes(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, set);
  EXPECT_EQ(VoxelSet::fromBytes(VoxelSet().bytes()), VoxelSet());
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_FALSE(VoxelSet::fromBytes(std::string_view(bytes).substr(0, length)));
  }
  for (int i = 0; i < 2000; ++i) {
    std::string changed = bytes;
    changed[static_cast<std::size_t>(random.within(0, static_cast<double>(bytes.size())))] ^= 0x10;
    const auto other = VoxelSet::fromBytes(changed);
    if (other) {
      EXPECT_EQ(other->bytes(), changed);
    }
  }
}

TEST(VoxelSet, hasTheBoundsOfItsVoxels) {
  VoxelSet set = setOf({{1, -20, 30}, {-4, 5, 6}});
  EXPECT_EQ(set.bounds(), (VoxelBounds{{-4, -20, 6}, {1, 5, 30}}));
}

TEST(VoxelSet, isCutBetweenVoxels) {
  RandomNumbers random(15);
  const Plain plain = randomPlain(random, 2000, 20);
  const VoxelSet set = setOf(plain);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::int32_t at = -22; at <= 22; ++at) {
      Plain lower;
      Plain upper;
      for (const Voxel& voxel : plain) (voxel[axis] < at ? lower : upper).insert(voxel);
      const auto parts = set.cut(axis, at);
      ASSERT_EQ(parts.first, setOf(lower));
      ASSERT_EQ(parts.second, setOf(upper));
    }
  }
}

TEST(VoxelSet, hangsTogetherByFacesEdgesAndCorners) {
  RandomNumbers random(16);
  for (int i = 0; i < 60; ++i) {
    const Plain plain = randomPlain(random, 20 + 5 * i, 9);
    const auto expected = plainComponents(plain);
    const auto found = setOf(plain).components();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) ASSERT_EQ(found[k].sorted(), listOf(expected[k]));
  }
}

/// Lines that wind through many blocks, and each of the 26 ways from one voxel to the next alone.
TEST(VoxelSet, hangsTogetherAcrossBlocksInAllDirections) {
  for (std::int32_t i = 0; i < 27; ++i) {
    const Voxel step{i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1};
    Plain plain;
    for (std::int32_t k = 0; k < 40; ++k) plain.insert({k * step[0] + 3, k * step[1] - 5, k * step[2] + 7});
    EXPECT_EQ(setOf(plain).components().size(), 1u) << i;
    Plain apart;
    for (std::int32_t k = 0; k < 40; ++k) apart.insert({2 * k * step[0], 2 * k * step[1], 2 * k * step[2]});
    EXPECT_EQ(setOf(apart).components().size(), apart.size()) << i;
  }
  RandomNumbers random(21);
  Plain wound;
  Voxel voxel{0, 0, 0};
  for (int i = 0; i < 5000; ++i) {
    for (std::int32_t& coordinate : voxel) {
      coordinate += static_cast<std::int32_t>(std::floor(random.within(-1, 2)));
    }
    wound.insert(voxel);
  }
  const auto components = setOf(wound).components();
  ASSERT_EQ(components.size(), 1u);
  EXPECT_EQ(components.front().sorted(), listOf(wound));
}

TEST(VoxelAt, isTheCubeInWhichThePointIs) {
  EXPECT_EQ(voxelAt({0.01, -0.01, 0.02}, 0.02), (Voxel{0, -1, 1}));
  RandomNumbers random(18);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d point = random.point(3);
    const AlignedBox cube = cubeOf(voxelAt(point, 0.02), 0.02);
    EXPECT_TRUE((point.array() >= cube.lower.array() - 1e-12).all());
    EXPECT_TRUE((point.array() <= cube.upper.array() + 1e-12).all());
  }
}

}  // namespace
}  // namespace cobot_command::cell
