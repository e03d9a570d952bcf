// The distances of the cells of the demos at their stations (cell.md, oracles 19 and 20).
#include <limits>
#include <map>
#include <string>

#include "cell_test_support.h"
#include <gtest/gtest.h>

#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

using Stations = std::map<std::string, arm::ControllerJoints>;

const Stations handover_stations = {{"HOME", {0, -30, 120, 0, 90, 0}}, {"T1", {0, 45, 60, -15, 90, 0}}};
const Stations head_on_stations = {
    {"HOME", {90, -45, 130, -85, 90, 0}}, {"P", {0, -10, 120, -90, 90, 0}}, {"W", {0, 55, 45, -80, 90, 0}}};
const Stations iris_stations = {
    {"HOME", {0, -60, 140, 10, 90, 0}}, {"P", {0, 0, 115, -85, 90, 0}}, {"W", {0, 60, 30, -60, 90, 0}}};
const RobotBodies left = robotAt({-720, 122.3, 0, 0, 0, 0});
const RobotBodies right = robotAt({720, -122.3, 0, 0, 0, 180});
const RobotBodies iris_1 = robotAt({330.9, 663.4, 0, 0, 0, -120});
const RobotBodies iris_2 = robotAt({-740.0, -45.1, 0, 0, 0, 0});

/// [mm]
double distanceAt(const RobotBodies& one, const RobotBodies& other, const Stations& stations,
                  const std::string& station, const std::string& other_station) {
  const auto here = one.at(arm::toJointVector(stations.at(station)));
  const auto there = other.at(arm::toJointVector(stations.at(other_station)));
  return mToMm(nearestOf(here.capsules, there.capsules).distance);
}

TEST(CellDistances, ofTheHandoverAreThoseOfItsOracle) {
  EXPECT_NEAR(distanceAt(left, right, handover_stations, "HOME", "HOME"), 659, 1);
  EXPECT_NEAR(distanceAt(left, right, handover_stations, "HOME", "T1"), 180, 1);
  EXPECT_NEAR(distanceAt(left, right, handover_stations, "T1", "HOME"), 180, 1);
  EXPECT_NEAR(distanceAt(left, right, handover_stations, "T1", "T1"), -86, 1);
}

TEST(CellDistances, ofTheHeadOnCellAreThoseOfItsOracle) {
  EXPECT_NEAR(distanceAt(left, right, head_on_stations, "HOME", "HOME"), 989, 1);
  EXPECT_NEAR(distanceAt(left, right, head_on_stations, "P", "P"), 205, 1);
  EXPECT_NEAR(distanceAt(left, right, head_on_stations, "P", "W"), -74, 1);
  EXPECT_NEAR(distanceAt(left, right, head_on_stations, "W", "W"), -25, 1);
}

TEST(CellDistances, ofTheIrisAreThoseOfItsOracle) {
  EXPECT_NEAR(distanceAt(iris_1, iris_2, iris_stations, "HOME", "HOME"), 902, 1);
  EXPECT_NEAR(distanceAt(iris_1, iris_2, iris_stations, "P", "P"), 249, 1);
  EXPECT_NEAR(distanceAt(iris_1, iris_2, iris_stations, "P", "W"), 156, 1);
  EXPECT_NEAR(distanceAt(iris_1, iris_2, iris_stations, "W", "P"), -9, 1);
  EXPECT_NEAR(distanceAt(iris_1, iris_2, iris_stations, "W", "W"), -55, 1);
}

TEST(CellDistances, tellWhichBodiesAreTheNearest) {
  const auto here = left.at(arm::toJointVector(handover_stations.at("T1")));
  const auto there = right.at(arm::toJointVector(handover_stations.at("HOME")));
  const Nearest nearest = nearestOf(here.capsules, there.capsules);
  EXPECT_EQ(left.bodies()[nearest.first].name, "link_5");
  EXPECT_EQ(distanceBetween(here.capsules[nearest.first], there.capsules[nearest.second]), nearest.distance);
  for (const Capsule& one : here.capsules) {
    for (const Capsule& other : there.capsules) EXPECT_GE(distanceBetween(one, other), nearest.distance);
  }
}

TEST(CellDistances, toNothingAreInfinite) {
  const auto here = left.at(arm::toJointVector(handover_stations.at("T1")));
  EXPECT_EQ(nearestOf(here.capsules, {}).distance, std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearestOf({}, here.capsules).distance, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace cobot_command::cell
