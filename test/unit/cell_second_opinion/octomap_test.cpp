// OctoMap itself reads the maps that are written for it (cell.md, S3).
#include <memory>
#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <octomap/octomap.h>

#include "cobot_command/cell/sweep/voxel_files.h"

namespace cobot_command::cell {
namespace {

constexpr double kEdge = 0.02;

/// A ball, which has full nodes of several sizes, and voxels by chance around it.
VoxelSet ballAndDust() {
  VoxelSet set;
  std::mt19937 chance(1);
  std::uniform_int_distribution<std::int32_t> coordinate(-40, 40);
  for (int i = 0; i < 2000; ++i) set.insert({coordinate(chance), coordinate(chance), coordinate(chance)});
  for (std::int32_t x = -20; x <= 20; ++x) {
    for (std::int32_t y = -20; y <= 20; ++y) {
      for (std::int32_t z = -20; z <= 20; ++z) {
        if (x * x + y * y + z * z <= 400) set.insert({x, y + 3, z - 5});
      }
    }
  }
  return set;
}

std::unique_ptr<octomap::OcTree> readBy(const std::string& bytes) {
  std::istringstream stream(bytes);
  auto tree = std::make_unique<octomap::OcTree>(0.1);
  return tree->readBinary(stream) ? std::move(tree) : nullptr;
}

TEST(OctoMap, readsTheVoxelsAtTheirPlaces) {
  const VoxelSet set = ballAndDust();
  const auto tree = readBy(*toOctomap(set, kEdge, "a ball and dust"));
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->getResolution(), kEdge);
  for (std::int32_t x = -45; x <= 45; ++x) {
    for (std::int32_t y = -45; y <= 45; ++y) {
      for (std::int32_t z = -45; z <= 45; ++z) {
        const auto* node = tree->search((x + 0.5) * kEdge, (y + 0.5) * kEdge, (z + 0.5) * kEdge);
        ASSERT_EQ(node != nullptr && tree->isNodeOccupied(node), set.contains({x, y, z}))
            << x << " " << y << " " << z;
      }
    }
  }
}

TEST(OctoMap, writesTheSameTreeInAsManyBytes) {
  const std::string ours = *toOctomap(ballAndDust(), kEdge, "a ball and dust");
  const auto tree = readBy(ours);
  ASSERT_TRUE(tree);
  std::ostringstream theirs;
  ASSERT_TRUE(tree->writeBinary(theirs));
  const auto data = [](const std::string& bytes) { return bytes.substr(bytes.find("\ndata\n")); };
  EXPECT_EQ(data(ours), data(theirs.str())) << "pruned, as ours is already";
}

TEST(OctoMap, readsAMapOfNothing) {
  const auto tree = readBy(*toOctomap(VoxelSet(), kEdge, "nothing"));
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->size(), 0U);
}

}  // namespace
}  // namespace cobot_command::cell
