// Zones, claims and distances as RViz shows them.
#include "cell_watch/pictures/cell_markers.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::HasSubstr;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;
using ZoneMessage = cobot_command::CellZone;

const ros::Time kStamp(3);

/// From the origin on, so many voxels along each edge.
cell::VoxelSet cubeOf(int voxels) {
  cell::VoxelSet set;
  for (int x = 0; x < voxels; ++x) {
    for (int y = 0; y < voxels; ++y) {
      for (int z = 0; z < voxels; ++z) set.insert({x, y, z});
    }
  }
  return set;
}

std::vector<Marker> named(const MarkerArray& array, const std::string& name) {
  std::vector<Marker> found;
  for (const Marker& marker : array.markers) {
    if (marker.ns == name && marker.action == Marker::ADD) found.push_back(marker);
  }
  return found;
}

bool isSameColour(const Marker& a, const Marker& b) {
  return a.color.r == b.color.r && a.color.g == b.color.g && a.color.b == b.color.b;
}
bool isGrey(const Marker& marker) {
  return std::abs(marker.color.r - marker.color.g) < 0.1 && std::abs(marker.color.g - marker.color.b) < 0.1;
}

class CellMarkers : public ::testing::Test {
 protected:
  CellMarkers() {
    scene.robots = {{"RA", Eigen::Vector3d(-1, 0, 0)}, {"RB", Eigen::Vector3d(1, 0, 0)}, {"TABLE", {}}};
    scene.zones = {{"Z1", hullOf(cubeOf(2), 0.02)}, {"Z2", hullOf(cubeOf(3), 0.02)}};
  }

  ZoneMessage& zone(const std::string& name, std::uint8_t state, const std::string& owner = "") {
    ZoneMessage message;
    message.name = name;
    message.state = state;
    message.owner = owner;
    told.zones.push_back(message);
    return told.zones.back();
  }
  [[nodiscard]] std::vector<Marker> shown(const std::string& name) const {
    return named(toZoneMarkers(scene, told, kStamp), name);
  }

  CellScene scene;
  cobot_command::CellState told;
};

TEST_F(CellMarkers, leaveOutVoxelsThatNobodyCanSee) {
  const VoxelHull hull = hullOf(cubeOf(4), 0.02);
  EXPECT_EQ(hull.centres.size(), 64U - 8U);
  EXPECT_NEAR(hull.centres.front().x, 0.01, 1e-12);
  EXPECT_TRUE(hull.box.lower.isApprox(Eigen::Vector3d::Zero()));
  EXPECT_TRUE(hull.box.upper.isApprox(Eigen::Vector3d(0.08, 0.08, 0.08)));
}

TEST_F(CellMarkers, areCubesInTheWorldWithTheEdgesOfTheirBox) {
  const auto cubes = shown("zones");
  ASSERT_EQ(cubes.size(), 2U);
  EXPECT_EQ(cubes[0].type, Marker::CUBE_LIST);
  EXPECT_EQ(cubes[0].header.frame_id, "world");
  EXPECT_EQ(cubes[0].points.size(), 8U);
  EXPECT_EQ(cubes[1].points.size(), 26U);
  EXPECT_NE(cubes[0].id, cubes[1].id);
  EXPECT_GT(cubes[0].scale.x, 0.015);
  EXPECT_LE(cubes[0].scale.x, 0.02);
  const auto edges = shown("edges");
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].type, Marker::LINE_LIST);
  EXPECT_EQ(edges[0].points.size(), 24U) << "twelve edges";
}

TEST_F(CellMarkers, areGreyWhileNobodyHoldsAZone) {
  zone("Z1", ZoneMessage::FREE);
  for (const Marker& cubes : shown("zones")) EXPECT_TRUE(isGrey(cubes)) << cubes.id;
  EXPECT_EQ(shown("names")[0].text, "Z1");
}

TEST_F(CellMarkers, haveTheColourOfTheOwner) {
  zone("Z1", ZoneMessage::HELD, "RA");
  zone("Z2", ZoneMessage::HELD, "RB");
  const auto cubes = shown("zones");
  EXPECT_FALSE(isGrey(cubes[0]));
  EXPECT_FALSE(isSameColour(cubes[0], cubes[1]));
  EXPECT_EQ(shown("names")[0].text, "Z1: RA");
  told.zones[0].owner = "RB";
  EXPECT_TRUE(isSameColour(shown("zones")[0], cubes[1]));
}

TEST_F(CellMarkers, areRedWhereAZoneIsQuarantined) {
  zone("Z1", ZoneMessage::QUARANTINED, "RA");
  const Marker cubes = shown("zones")[0];
  EXPECT_GT(cubes.color.r, 0.8F);
  EXPECT_LT(cubes.color.g, 0.2F);
  EXPECT_EQ(shown("names")[0].text, "Z1: RA, quarantined");
}

TEST_F(CellMarkers, haveALineFromEachRobotThatWaitsToItsZone) {
  EXPECT_TRUE(shown("waiting").empty());
  zone("Z1", ZoneMessage::HELD, "RA").waiting = {"RB", "TABLE", "nobody"};
  const auto lines = shown("waiting");
  ASSERT_EQ(lines.size(), 1U) << "only robots have a base";
  ASSERT_EQ(lines[0].points.size(), 2U);
  EXPECT_EQ(lines[0].points[0].x, 1);
  EXPECT_NEAR(lines[0].points[1].x, 0.02, 1e-12);
}

TEST_F(CellMarkers, takeAwayWhatWasThereBefore) {
  const MarkerArray array = toZoneMarkers(scene, told, kStamp);
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
}

TEST_F(CellMarkers, ofClaimsAreTranslucentAndOfTheColourOfTheirRobot) {
  std::vector<cell::RobotClaim> claims(2);
  claims[0].all = cubeOf(3);
  claims[1].all = cubeOf(2);
  const MarkerArray array = toClaimMarkers(claims, 0.02, kStamp);
  const auto cubes = named(array, "claims");
  ASSERT_EQ(cubes.size(), 2U);
  EXPECT_EQ(cubes[0].points.size(), 26U);
  EXPECT_LT(cubes[0].color.a, 0.5F);
  EXPECT_GT(cubes[0].color.a, 0.0F);
  zone("Z1", ZoneMessage::HELD, "RA");
  EXPECT_TRUE(isSameColour(cubes[0], shown("zones")[0]));
  EXPECT_EQ(toClaimMarkers({}, 0.02, kStamp).markers.size(), 1U) << "only takes away";
}

TEST_F(CellMarkers, ofTheShortestWayAreALineAndItsLength) {
  const ShortestWay way{{0, 0, 1}, {0.1, 0, 1}, 0.1, false};
  const MarkerArray array = toDistanceMarkers(way, kStamp);
  ASSERT_EQ(named(array, "way").size(), 1U);
  EXPECT_EQ(named(array, "way")[0].points[1].x, 0.1);
  EXPECT_EQ(named(array, "distance")[0].text, "100 mm");
  EXPECT_EQ(toDistanceMarkers(std::nullopt, kStamp).markers.size(), 1U) << "only takes away";
}

}  // namespace
}  // namespace cobot_command::ros_adapter
