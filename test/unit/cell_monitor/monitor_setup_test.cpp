// The monitor of a cell, made of the cell's file.
#include <algorithm>
#include <string>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/runtime/cell/cell_files.h"
#include "cobot_command/runtime/cell/cell_watch.h"

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;
using Mode = MonitorSettings::Mode;

const arm::JointVector kHome = arm::toJointVector({0, -30, 120, 0, 90, 0});
const arm::JointVector kT1 = arm::toJointVector({0, 45, 60, -15, 90, 0});
const Instant kNow(std::chrono::seconds(1));

Cell cellNamed(const std::string& name) {
  return *runtime::readCellFile(test_support::inSourceTree("config/cells/" + name + ".yaml"));
}

Monitor monitorOf(const Cell& cell, Mode mode = Mode::Stop,
                  std::optional<double> stop_distance = std::nullopt) {
  return *runtime::monitorOf(cell, mode, stop_distance);
}

void stand(Monitor& monitor, const arm::JointVector& left, const arm::JointVector& right) {
  monitor.take("RA", left, arm::JointVector::Zero(), Duration(0), kNow);
  monitor.take("RB", right, arm::JointVector::Zero(), Duration(0), kNow);
  monitor.tick(kNow);
}

TEST(MonitorOfAFile, measuresTheDistancesOfTheOracle) {
  Monitor monitor = monitorOf(cellNamed("handover"));
  stand(monitor, kHome, kT1);
  ASSERT_EQ(monitor.status().pairs.size(), 1U);
  EXPECT_NEAR(monitor.status().pairs.front().distance, 0.180, 0.001);
  EXPECT_FALSE(monitor.latched());
}

TEST(MonitorOfAFile, stopsAllWhereToolsReachIntoEachOtherUnlessItOnlyWarns) {
  const Cell cell = cellNamed("handover");
  Monitor stops = monitorOf(cell);
  stand(stops, kT1, kT1);
  EXPECT_TRUE(stops.latched());
  Monitor warns = monitorOf(cell, Mode::Warn);
  stand(warns, kT1, kT1);
  EXPECT_FALSE(warns.latched());
}

TEST(MonitorOfAFile, knowsTheMarginOfTheCell) {
  Cell cell = cellNamed("handover");
  cell.parameters.margin = 0.2;  // more than the 180 mm from home to T1
  Monitor breached = monitorOf(cell);
  stand(breached, kHome, kT1);
  EXPECT_TRUE(breached.status().pairs.front().breached);
  EXPECT_FALSE(breached.latched()) << "half of the margin stops";
  Monitor stopped = monitorOf(cell, Mode::Stop, 0.19);
  stand(stopped, kHome, kT1);
  EXPECT_TRUE(stopped.latched());
}

TEST(MonitorOfAFile, refusesAStopDistanceAboveTheMargin) {
  const auto monitor = runtime::monitorOf(cellNamed("handover"), Mode::Stop, 0.03);
  ASSERT_FALSE(monitor);
  EXPECT_THAT(monitor.error(), HasSubstr("0.03"));
}

TEST(MonitorOfAFile, takesARobotToCarryAllThatItsProgramAttaches) {
  Cell cell = cellNamed("handover");
  Part sheet;
  sheet.name = "sheet";
  sheet.shapes = {{SphereShape{0.25}, arm::Pose::Identity()}};
  cell.parts = {sheet};
  const auto bare = *runtime::watchedRobots(cell);
  for (const auto& robot : bare) EXPECT_TRUE(robot.may_carry.empty());
  cell.robots[1].program[0].steps[0].attach = "sheet";
  const auto robots = *runtime::watchedRobots(cell);
  EXPECT_TRUE(robots[0].may_carry.empty());
  ASSERT_EQ(robots[1].may_carry.size(), 1U);
  EXPECT_EQ(robots[1].may_carry[0].name, "sheet");
  Monitor monitor = monitorOf(cell);
  stand(monitor, kHome, kT1);
  EXPECT_LT(monitor.status().pairs.front().distance, 0.170) << "nearer than without the sheet";
}

TEST(MonitorOfAFile, watchesRobotsAndObstacles) {
  Cell cell = cellNamed("handover");
  Obstacle wall;
  wall.name = "wall";
  wall.shapes = {{SphereShape{0.1}, arm::Pose(Eigen::Translation3d(0, 2, 1))}};
  cell.obstacles = {wall};
  Monitor monitor = monitorOf(cell);
  stand(monitor, kHome, kHome);
  const auto pairs = monitor.status().pairs;
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_TRUE(
      std::any_of(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.second == "wall"; }));
}

TEST(MonitorOfAFile, isMadeOfEachCellThatComesWithThis) {
  for (const char* name : {"handover", "head_on", "iris", "corridor", "pallet"}) {
    EXPECT_TRUE(runtime::monitorOf(cellNamed(name), Mode::Stop, std::nullopt)) << name;
  }
}

}  // namespace
}  // namespace cobot_command::cell
