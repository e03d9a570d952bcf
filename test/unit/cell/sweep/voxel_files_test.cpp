// Files of voxels, read back by code that knows only their formats.
#include "cobot_command/cell/sweep/voxel_files.h"

#include <array>
#include <sstream>

#include "cell_test_support.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double kEdge = 0.02;

VoxelSet randomSet(std::uint64_t seed, int count, double size) {
  RandomNumbers random(seed);
  VoxelSet set;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d point = random.point(size);
    set.insert({static_cast<std::int32_t>(std::floor(point.x())),
                static_cast<std::int32_t>(std::floor(point.y())),
                static_cast<std::int32_t>(std::floor(point.z()))});
  }
  return set;
}

VoxelSet boxOf(const Voxel& lower, std::int32_t size) {
  VoxelSet box;
  for (std::int32_t x = 0; x < size; ++x) {
    for (std::int32_t y = 0; y < size; ++y) {
      for (std::int32_t z = 0; z < size; ++z) box.insert({lower[0] + x, lower[1] + y, lower[2] + z});
    }
  }
  return box;
}

std::vector<VoxelSet> someSets() {
  VoxelSet corners;
  for (const std::int32_t end : {-kFarthestOfOctomap, kFarthestOfOctomap - 1}) corners.insert({end, end, 0});
  return {VoxelSet(),
          boxOf({3, -4, 5}, 1),
          boxOf({-8, 0, 16}, 8),
          boxOf({-3, -5, 2}, 11),
          boxOf({-32, -32, -32}, 32) | boxOf({0, 0, 0}, 2),
          randomSet(1, 500, 6.0),
          randomSet(2, 2000, 300.0),
          corners};
}

/// What a viewer makes of it: the lines of the head, and three numbers of each vertex.
struct Ply {
  explicit Ply(const std::string& bytes) {
    std::istringstream stream(bytes);
    std::size_t vertices = 0;
    for (std::string line; std::getline(stream, line) && line != "end_header";) {
      head += line + "\n";
      if (line.rfind("element vertex ", 0) == 0) vertices = std::stoul(line.substr(15));
    }
    for (std::size_t index = 0; index < vertices; ++index) {
      std::array<float, 3> vertex{};
      stream.read(reinterpret_cast<char*>(vertex.data()), sizeof(vertex));
      EXPECT_TRUE(stream) << "fewer vertices than told";
      voxels.insert(voxelAt(Eigen::Vector3d(vertex[0], vertex[1], vertex[2]), kEdge));
    }
    EXPECT_EQ(stream.peek(), EOF);
  }

  std::string head;
  VoxelSet voxels;
};

/// As the format is described: nodes depth first, two bits for each child.
class BtReader {
 public:
  explicit BtReader(const std::string& bytes) : stream_(bytes) {
    std::string line;
    std::getline(stream_, line);
    EXPECT_EQ(line, "# Octomap OcTree binary file");
    while (std::getline(stream_, line) && line != "data") {
      if (line.rfind("id ", 0) == 0) id = line.substr(3);
      if (line.rfind("size ", 0) == 0) size = std::stoul(line.substr(5));
      if (line.rfind("res ", 0) == 0) resolution = std::stod(line.substr(4));
    }
    if (size > 0) readNode({0, 0, 0}, 1 << 16);
    EXPECT_EQ(stream_.peek(), EOF);
    EXPECT_EQ(nodes_, size);
  }

  std::string id;
  std::size_t size = 0;
  double resolution = 0.0;
  VoxelSet voxels;

 private:
  void readNode(const Voxel& corner, std::int32_t edge) {
    ++nodes_;
    std::array<unsigned, 2> bytes{};
    for (unsigned& byte : bytes) byte = static_cast<unsigned>(stream_.get());
    ASSERT_TRUE(stream_);
    const std::int32_t half = edge / 2;
    std::vector<Voxel> inner;
    for (unsigned child = 0; child < 8; ++child) {
      const Voxel at{corner[0] + ((child & 1U) != 0 ? half : 0), corner[1] + ((child & 2U) != 0 ? half : 0),
                     corner[2] + ((child & 4U) != 0 ? half : 0)};
      const bool low = ((bytes[child / 4] >> (2 * (child % 4))) & 1U) != 0;
      const bool high = ((bytes[child / 4] >> (2 * (child % 4) + 1)) & 1U) != 0;
      EXPECT_TRUE(!low || high) << "nothing is known to be free";
      if (low && high) inner.push_back(at);
      if (!low && high) fill(at, half);
    }
    for (const Voxel& at : inner) readNode(at, half);
  }
  void fill(const Voxel& corner, std::int32_t edge) {
    ++nodes_;
    voxels |= boxOf({corner[0] - 32768, corner[1] - 32768, corner[2] - 32768}, edge);
  }

  std::istringstream stream_;
  std::size_t nodes_ = 0;
};

TEST(APointCloudOfVoxels, hasTheCentreOfEach) {
  for (const VoxelSet& set : someSets()) {
    const Ply ply(toPly(set, kEdge, "zone Z1 of RA and RB"));
    EXPECT_THAT(ply.head, StartsWith("ply\nformat binary_little_endian 1.0\ncomment zone Z1 of RA and RB\n"));
    EXPECT_EQ(ply.voxels, set);
  }
}

TEST(AMapOfOctomap, hasTheVoxelsAndNothingElse) {
  for (const VoxelSet& set : someSets()) {
    const auto bytes = toOctomap(set, kEdge, "zone Z1 of RA and RB");
    ASSERT_TRUE(bytes) << bytes.error();
    const BtReader map(*bytes);
    EXPECT_EQ(map.id, "OcTree");
    EXPECT_EQ(map.resolution, kEdge);
    EXPECT_EQ(map.voxels, set);
  }
}

TEST(AMapOfOctomap, hasOneNodeForWhatIsFull) {
  // The cube of 8 is one leaf: on the way to it there are 13 nodes, the root included.
  EXPECT_EQ(BtReader(*toOctomap(boxOf({-8, 0, 16}, 8), kEdge, "")).size, 14U);
  EXPECT_EQ(BtReader(*toOctomap(boxOf({3, -4, 5}, 1), kEdge, "")).size, 17U);
  EXPECT_EQ(BtReader(*toOctomap(VoxelSet(), kEdge, "")).size, 0U);
}

TEST(AMapOfOctomap, refusesVoxelsThatAreTooFar) {
  for (const Voxel& voxel : {Voxel{kFarthestOfOctomap, 0, 0}, Voxel{0, 0, -kFarthestOfOctomap - 1}}) {
    VoxelSet set;
    set.insert(voxel);
    const auto bytes = toOctomap(set, kEdge, "");
    ASSERT_FALSE(bytes);
    EXPECT_THAT(bytes.error(), HasSubstr("with voxels of 20 mm extends from -655.4 to 655.4 m"));
  }
}

TEST(FilesOfVoxels, haveTheSameBytesHoweverTheVoxelsCameIn) {
  const std::vector<Voxel> voxels = randomSet(3, 300, 20.0).sorted();
  VoxelSet forwards;
  VoxelSet backwards;
  for (auto voxel = voxels.begin(); voxel != voxels.end(); ++voxel) forwards.insert(*voxel);
  for (auto voxel = voxels.rbegin(); voxel != voxels.rend(); ++voxel) backwards.insert(*voxel);
  EXPECT_EQ(toPly(forwards, kEdge, ""), toPly(backwards, kEdge, ""));
  EXPECT_EQ(*toOctomap(forwards, kEdge, ""), *toOctomap(backwards, kEdge, ""));
}

}  // namespace
}  // namespace cobot_command::cell
