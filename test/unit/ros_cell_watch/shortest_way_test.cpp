// The shortest way between two robots of the handover, or a robot and the pallet, against the distance that
// the monitor has found.
#include "cell_watch/pictures/shortest_way.h"

#include <algorithm>

#include "source_tree.h"
#include <gmock/gmock.h>

#include "cobot_command/runtime/cell/cell_files.h"
#include "cobot_command/runtime/cell/cell_watch.h"

namespace cobot_command::ros_adapter {
namespace {

const arm::JointVector kHome = arm::toJointVector({0, -30, 120, 0, 90, 0});
const arm::JointVector kT1 = arm::toJointVector({0, 45, 60, -15, 90, 0});

WatchView viewOf(const cell::Monitor& monitor, const std::vector<std::string>& movers) {
  WatchView view;
  view.status = monitor.status();
  view.bodies = monitor.bodies();
  for (const std::string& name : movers) view.movers.push_back({name, "/" + name, "", true, true, ""});
  return view;
}

class ShortestWayOfTheHandover : public ::testing::Test {
 protected:
  ShortestWayOfTheHandover()
      : cell(*runtime::readCellFile(test_support::inSourceTree("config/cells/handover.yaml"))),
        monitor(*runtime::monitorOf(cell, cell::MonitorSettings::Mode::Warn, std::nullopt)) {}

  WatchView viewAt(const arm::JointVector& left, const arm::JointVector& right) {
    const Instant now(std::chrono::seconds(1));
    monitor.take("RA", left, arm::JointVector::Zero(), Duration(0), now);
    monitor.take("RB", right, arm::JointVector::Zero(), Duration(0), now);
    monitor.tick(now);
    return viewOf(monitor, {"RA", "RB"});
  }

  cell::Cell cell;
  cell::Monitor monitor;
};

TEST_F(ShortestWayOfTheHandover, isAsLongAsTheMonitorSays) {
  const WatchView view = viewAt(kHome, kT1);
  const auto way = shortestWay(view);
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->distance, 0.180, 0.001);
  EXPECT_NEAR((way->to - way->from).norm(), view.status.pairs.front().distance, 1e-9);
  EXPECT_LT(way->from.x(), way->to.x()) << "from RA on the left to RB";
}

TEST_F(ShortestWayOfTheHandover, isAlsoThereWhereBodiesReachIntoEachOther) {
  const auto way = shortestWay(viewAt(kT1, kT1));
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->distance, -0.086, 0.001);
  EXPECT_TRUE(way->breached);
}

TEST_F(ShortestWayOfTheHandover, isNoneWhileARobotWasNotHeard) {
  EXPECT_FALSE(shortestWay(WatchView()));
  monitor.take("RA", kHome, arm::JointVector::Zero(), Duration(0), Instant(std::chrono::seconds(1)));
  monitor.tick(Instant(std::chrono::seconds(1)));
  EXPECT_FALSE(shortestWay(viewOf(monitor, {"RA", "RB"})));
}

TEST(ShortestWayOfThePallet, leadsFromTheRobotToThePalletAndNotToTheFence) {
  const auto cell = runtime::readCellFile(test_support::inSourceTree("config/cells/pallet.yaml"));
  ASSERT_TRUE(cell);
  auto monitor = *runtime::monitorOf(*cell, cell::MonitorSettings::Mode::Warn, std::nullopt);
  const Instant now(std::chrono::seconds(1));
  monitor.take("RA", kT1, arm::JointVector::Zero(), Duration(0), now);
  monitor.takePosition("PALLET", 0.9, Duration(0), now);
  monitor.tick(now);
  const WatchView view = viewOf(monitor, {"RA", "PALLET"});
  const auto way = shortestWay(view);
  ASSERT_TRUE(way);
  const auto& pairs = view.status.pairs;
  const auto pair =
      std::find_if(pairs.begin(), pairs.end(), [](const auto& one) { return one.second == "PALLET"; });
  ASSERT_NE(pair, pairs.end());
  EXPECT_NEAR(way->distance, pair->distance, 1e-9);
  EXPECT_NEAR(way->to.x(), 0, 0.3) << "where the pallet is in";
  EXPECT_EQ(view.bodies.size(), 3U) << "the fence is seen, too";
}

}  // namespace
}  // namespace cobot_command::ros_adapter
