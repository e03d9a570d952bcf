// Robots, mechanisms and obstacles as RViz shows them.
#include "cell_watch/pictures/body_markers.h"

#include <algorithm>

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const ros::Time kStamp(3);

cell::SeenBodies robot(const std::string& name) {
  return {name,
          {{{0, 0, 0}, {0, 0, 1}, 0.1}, {{0, 0, 1}, {1, 0, 1}, 0.1}, {{1, 0, 1}, {1, 0, 1}, 0.05}},
          {"link_0", "link_1", "tool"}};
}

std::vector<Marker> of(const MarkerArray& array, const std::string& name, int type) {
  std::vector<Marker> found;
  for (const Marker& marker : array.markers) {
    if (marker.ns == name && marker.type == type) found.push_back(marker);
  }
  return found;
}

float paleness(const std_msgs::ColorRGBA& colour) {
  return std::min({colour.r, colour.g, colour.b});
}

TEST(BodyMarkers, areACylinderAndTwoBallsForEachCapsuleInTheWorld) {
  const MarkerArray array = toBodyMarkers({robot("LEFT")}, 1, kStamp);
  const auto cores = of(array, "LEFT", Marker::CYLINDER);
  ASSERT_EQ(cores.size(), 2U) << "a ball has no core";
  EXPECT_EQ(cores[0].header.frame_id, "world");
  EXPECT_NEAR(cores[0].scale.x, 0.2, 1e-12);
  EXPECT_NEAR(cores[0].scale.z, 1, 1e-12);
  EXPECT_NEAR(cores[1].pose.position.x, 0.5, 1e-12);
  EXPECT_NEAR(cores[1].pose.position.z, 1, 1e-12);
  EXPECT_NEAR(std::abs(cores[1].pose.orientation.y), std::sqrt(0.5), 1e-9) << "z of the cylinder is along x";
  const auto balls = of(array, "LEFT", Marker::SPHERE_LIST);
  ASSERT_EQ(balls.size(), 2U) << "one for each size";
  EXPECT_EQ(balls[0].points.size(), 2U);
  EXPECT_NEAR(balls[0].scale.y, 0.1, 1e-12);
  EXPECT_EQ(balls[1].points.size(), 4U);
  EXPECT_EQ(balls[1].colors.size(), 4U);
}

TEST(BodyMarkers, haveTheNameOfTheirThingAboveIt) {
  const MarkerArray array = toBodyMarkers({robot("LEFT"), robot("hall_2_arm")}, 2, kStamp);
  const auto names = of(array, "hall_2_arm", Marker::TEXT_VIEW_FACING);
  ASSERT_EQ(names.size(), 1U);
  EXPECT_EQ(names[0].text, "hall_2_arm");
  EXPECT_GT(names[0].pose.position.z, 1.1);
  EXPECT_NEAR(names[0].pose.position.x, 0.5, 1e-9);
}

TEST(BodyMarkers, haveTheColourOfTheirThingAndLinksAPalerOne) {
  const MarkerArray array = toBodyMarkers({robot("LEFT"), robot("RIGHT"), robot("fence")}, 2, kStamp);
  const auto left = of(array, "LEFT", Marker::SPHERE_LIST);
  const auto right = of(array, "RIGHT", Marker::SPHERE_LIST);
  const auto fence = of(array, "fence", Marker::SPHERE_LIST);
  EXPECT_NE(left[0].colors[0], right[0].colors[0]);
  EXPECT_GT(paleness(left[1].colors[0]), paleness(left[0].colors[0])) << "of a link, and of the tool";
  EXPECT_NEAR(fence[0].colors[0].r, fence[0].colors[0].b, 0.1) << "grey";
  EXPECT_LT(fence[0].colors[0].a, 1.0F);
  EXPECT_EQ(left[0].colors[0].a, 1.0F);
}

TEST(BodyMarkers, haveIdsOfTheirOwn) {
  const MarkerArray array = toBodyMarkers({robot("LEFT"), robot("RIGHT")}, 2, kStamp);
  std::set<std::pair<std::string, int>> ids;
  for (const Marker& marker : array.markers) ids.insert({marker.ns, marker.id});
  EXPECT_EQ(ids.size(), array.markers.size());
}

TEST(BodyMarkers, areNoneOfWhatWasNotMeasured) {
  EXPECT_TRUE(toBodyMarkers({{"LEFT", {}, {}}}, 1, kStamp).markers.empty());
}

TEST(BodyMarkers, areTheSameOnesWhileNothingIsTakenOrSetDown) {
  const auto drawn = [](const cell::SeenBodies& one, const cell::SeenBodies& other) {
    return toBodyMarkers({one, other}, 2, kStamp);
  };
  cell::SeenBodies moved = robot("LEFT");
  moved.capsules[1].to.y() = 0.5;
  EXPECT_TRUE(areSameMarkers(drawn(robot("LEFT"), robot("RIGHT")), drawn(moved, robot("RIGHT"))));
  cell::SeenBodies left = robot("LEFT");
  cell::SeenBodies right = robot("RIGHT");
  left.capsules.pop_back();
  right.capsules.pop_back();
  EXPECT_FALSE(areSameMarkers(drawn(left, robot("RIGHT")), drawn(robot("LEFT"), right)))
      << "it was handed over";
}

}  // namespace
}  // namespace cobot_command::ros_adapter
