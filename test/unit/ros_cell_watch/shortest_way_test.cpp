// The shortest way between two robots of the handover, against the distance that the monitor has found.
#include "cell_watch/shortest_way.h"

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/runtime/cell/cell_files.h"
#include "cobot_command/runtime/cell/cell_watch.h"

namespace cobot_command::ros_adapter {
namespace {

const arm::JointVector kHome = arm::toJointVector({0, -30, 120, 0, 90, 0});
const arm::JointVector kT1 = arm::toJointVector({0, 45, 60, -15, 90, 0});

class ShortestWayOfTheHandover : public ::testing::Test {
 protected:
  ShortestWayOfTheHandover()
      : cell(*runtime::readCellFile(test_support::inSourceTree("config/cells/handover.yaml"))),
        monitor(*runtime::monitorOf(cell, cell::MonitorSettings::Mode::Warn, std::nullopt)) {
    const auto robots = *runtime::watchedRobots(cell);
    for (const auto& robot : robots) bodies.push_back(robot.bodies);
  }

  WatchView viewAt(const arm::JointVector& left, const arm::JointVector& right) {
    const Instant now(std::chrono::seconds(1));
    monitor.take("RA", left, arm::JointVector::Zero(), Duration(0), now);
    monitor.take("RB", right, arm::JointVector::Zero(), Duration(0), now);
    monitor.tick(now);
    WatchView view;
    view.status = monitor.status();
    view.robots = {{"RA", "/RA", left, true}, {"RB", "/RB", right, true}};
    return view;
  }

  cell::Cell cell;
  cell::Monitor monitor;
  std::vector<cell::RobotBodies> bodies;
};

TEST_F(ShortestWayOfTheHandover, isAsLongAsTheMonitorSays) {
  const WatchView view = viewAt(kHome, kT1);
  const auto way = shortestWay(bodies, view);
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->distance, 0.180, 0.001);
  EXPECT_NEAR((way->to - way->from).norm(), view.status.pairs.front().distance, 1e-9);
  EXPECT_LT(way->from.x(), way->to.x()) << "from RA on the left to RB";
}

TEST_F(ShortestWayOfTheHandover, isAlsoThereWhereBodiesReachIntoEachOther) {
  const auto way = shortestWay(bodies, viewAt(kT1, kT1));
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->distance, -0.086, 0.001);
  EXPECT_TRUE(way->breached);
}

TEST_F(ShortestWayOfTheHandover, isNoneWhileARobotWasNotHeard) {
  EXPECT_FALSE(shortestWay(bodies, WatchView()));
  WatchView view = viewAt(kHome, kT1);
  view.robots[1].joints.reset();
  EXPECT_FALSE(shortestWay(bodies, view));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
