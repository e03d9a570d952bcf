// What becomes a zone of its own (cell.md, M11).
#include <gmock/gmock.h>

#include "cobot_command/cell/zones/zones.h"

namespace cobot_command::cell {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

void insertBox(VoxelSet& voxels, const Voxel& lower, const Voxel& upper) {
  for (auto x = lower[0]; x <= upper[0]; ++x) {
    for (auto y = lower[1]; y <= upper[1]; ++y) {
      for (auto z = lower[2]; z <= upper[2]; ++z) voxels.insert({x, y, z});
    }
  }
}

/// How many voxels each zone has of two robots that share these.
std::vector<std::size_t> zonesOf(const VoxelSet& shared, double zone_size = 1.0) {
  std::vector<RobotClaim> claims(2);
  claims[0].name = "RA";
  claims[1].name = "RB";
  for (RobotClaim& claim : claims) claim.all = shared;
  Parameters parameters;
  parameters.zone_size = zone_size;
  const auto zones = findZones(claims, parameters);
  EXPECT_TRUE(zones);
  std::vector<std::size_t> counts;
  for (const Zone& zone : *zones) counts.push_back(zone.voxels.count());
  return counts;
}

VoxelSet block() {
  VoxelSet voxels;
  insertBox(voxels, {0, 0, 0}, {4, 4, 4});
  return voxels;
}

TEST(AFewVoxels, areNoZoneOfTheirOwnBesideAnotherOne) {
  VoxelSet voxels = block();
  voxels.insert({6, 2, 2});
  voxels.insert({9, 9, 4});
  EXPECT_THAT(zonesOf(voxels), ElementsAre(127));
}

TEST(AFewVoxels, areOneFarFromAllOthers) {
  VoxelSet voxels = block();
  voxels.insert({10, 2, 2});
  EXPECT_THAT(zonesOf(voxels), ElementsAre(125, 1));
}

TEST(AFewVoxels, areOneTogetherWhereTheyAreNearToEachOther) {
  VoxelSet voxels;
  for (const std::int32_t at : {0, 3, 6}) voxels.insert({at, 0, 0});
  EXPECT_THAT(zonesOf(voxels), ElementsAre(3));
}

TEST(AFewVoxels, makeNoZoneLongerThanIsAllowed) {
  VoxelSet voxels = block();
  voxels.insert({6, 2, 2});
  EXPECT_THAT(zonesOf(voxels, 0.12), ElementsAre(125, 1)) << "six voxels of 20 mm";
}

TEST(MoreVoxels, areAZoneOfTheirOwn) {
  VoxelSet voxels = block();
  insertBox(voxels, {6, 0, 0}, {7, 1, 1});
  EXPECT_THAT(zonesOf(voxels), ElementsAre(125, 8));
}

TEST(NoVoxels, areNoZone) {
  EXPECT_THAT(zonesOf({}), IsEmpty());
}

}  // namespace
}  // namespace cobot_command::cell
