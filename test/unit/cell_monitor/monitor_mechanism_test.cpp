// Mechanisms under watch: how far robots and other mechanisms are from them, and what stops all (cell.md, M2
// and M35).
#include <cmath>
#include <limits>

#include "watched_cell.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

constexpr double kOut = 0.0;  // [m]
constexpr double kIn = 0.9;

/// A pallet that slides along y, below where the left robot has its tool at T1.
MechanismBodies palletBodies() {
  MotionAxis axis;
  axis.at.translation() = Eigen::Vector3d(0, -0.9, 0.15);
  axis.direction = Eigen::Vector3d::UnitY();
  return *MechanismBodies::of(axis, {{BoxShape{{0.4, 0.4, 0.15}}, arm::Pose::Identity()}});
}

/// A bar of 1 m that turns about its one end.
MechanismBodies tableBodies(const Eigen::Vector3d& place) {
  MotionAxis axis;
  axis.turns = true;
  axis.at.translation() = place;
  return {axis, {{{0, 0, 0}, {1, 0, 0}, 0.05}}};
}

Monitor palletCell(const MonitorSettings& settings = {}, const std::vector<WatchedObstacle>& obstacles = {}) {
  auto monitor = Monitor::of({{"left", leftBodies(), {}}}, obstacles, settings, {{"pallet", palletBodies()}});
  if (!monitor) throw std::runtime_error(monitor.error().message);
  return std::move(*monitor);
}

Monitor tables(double apart) {
  auto monitor =
      Monitor::of({}, {}, {}, {{"one", tableBodies({0, 0, 0})}, {"other", tableBodies({0, apart, 0})}});
  if (!monitor) throw std::runtime_error(monitor.error().message);
  return std::move(*monitor);
}

/// Twice there: it stands.
void standAt(Monitor& monitor, const std::string& mechanism, double position, Instant now) {
  monitor.takePosition(mechanism, position, fromSeconds(0.02), now);
  monitor.takePosition(mechanism, position, Duration(0), now);
}

TEST(MonitorOfMechanisms, tellsHowFarARobotIsFromWhereOneIsMeasured) {
  for (const double position : {kOut, 0.4, kIn}) {
    Monitor monitor = palletCell();
    monitor.take("left", kHome, kStanding, Duration(0), at(1));
    standAt(monitor, "pallet", position, at(1));
    monitor.tick(at(1));
    ASSERT_EQ(monitor.status().pairs.size(), 1U);
    const PairStatus pair = monitor.status().pairs.front();
    const double distance = nearestOf(leftBodies().at(kHome).capsules, palletBodies().at(position)).distance;
    EXPECT_TRUE(pair.known);
    EXPECT_NEAR(pair.distance, distance, 1e-12) << position;
    EXPECT_EQ(pair.first, "left");
    EXPECT_EQ(pair.second, "pallet");
    EXPECT_EQ(pair.second_body, "pallet");
    EXPECT_EQ(pair.uncertainty, 0);
  }
}

TEST(MonitorOfMechanisms, doesNotKnowADistanceBeforeOneWasHeard) {
  Monitor monitor = palletCell();
  monitor.take("left", kHome, kStanding, Duration(0), at(1));
  monitor.tick(at(1));
  EXPECT_FALSE(monitor.status().pairs.front().known);
  EXPECT_EQ(monitor.status().diagnosis, "pallet has not reported yet.");
}

TEST(MonitorOfMechanisms, stopsAllWhereARobotIsTooCloseToOne) {
  Monitor monitor = palletCell();
  monitor.take("left", kT1, kStanding, Duration(0), at(1));
  standAt(monitor, "pallet", kOut, at(1));
  monitor.tick(at(1));
  EXPECT_FALSE(monitor.latched());
  standAt(monitor, "pallet", kIn, at(9));
  monitor.tick(at(9));
  const auto stops = only<StopAll>(monitor.takeActions());
  ASSERT_EQ(stops.size(), 1U);
  EXPECT_NE(stops[0].why.find("pallet (pallet)"), std::string::npos) << stops[0].why;
  EXPECT_FALSE(monitor.reset(at(9.1)).success);
  standAt(monitor, "pallet", kOut, at(20));
  EXPECT_TRUE(monitor.reset(at(20)).success);
}

TEST(MonitorOfMechanisms, countsWhatOneMayHaveMovedSinceByItsSpeed) {
  Monitor monitor = palletCell();
  monitor.take("left", kHome, kStanding, Duration(0), at(1.1));
  monitor.takePosition("pallet", 0.10, Duration(0), at(1));
  monitor.takePosition("pallet", 0.12, Duration(0), at(1.1));
  monitor.tick(at(1.3));
  EXPECT_NEAR(monitor.status().pairs.front().uncertainty, 0.2 * 0.2, 1e-9);
}

TEST(MonitorOfMechanisms, countsTheReachOfOneThatTurns) {
  Monitor monitor = tables(1.5);
  standAt(monitor, "one", 0.0, at(1.1));
  monitor.takePosition("other", 0.00, Duration(0), at(1));
  monitor.takePosition("other", 0.01, Duration(0), at(1.1));
  monitor.tick(at(1.2));
  EXPECT_NEAR(monitor.status().pairs.front().uncertainty, (1 + 0.05) * 0.01, 1e-9);
}

TEST(MonitorOfMechanisms, watchesTwoOfThemAgainstEachOther) {
  Monitor monitor = tables(1.5);
  standAt(monitor, "one", 0.0, at(1));
  standAt(monitor, "other", 0.0, at(1));
  monitor.tick(at(1));
  EXPECT_NEAR(monitor.status().pairs.front().distance, 1.4, 1e-12);
  standAt(monitor, "one", 0.5 * kPi, at(9));
  monitor.tick(at(9));
  EXPECT_NEAR(monitor.status().pairs.front().distance, 0.4, 1e-12);
  standAt(monitor, "other", -0.5 * kPi, at(20));
  monitor.tick(at(20));
  EXPECT_TRUE(monitor.latched());
}

TEST(MonitorOfMechanisms, leavesObstaclesToTheProofOfTheirWays) {
  const Capsule on_the_way{{0, 0, 0.15}, {0, 0, 0.15}, 0.05};
  Monitor monitor = palletCell({}, {{"post", {on_the_way}}});
  monitor.take("left", kHome, kStanding, Duration(0), at(1));
  standAt(monitor, "pallet", kIn, at(1));
  monitor.tick(at(1));
  ASSERT_EQ(monitor.status().pairs.size(), 2U);
  for (const PairStatus& pair : monitor.status().pairs) EXPECT_EQ(pair.first, "left");
  EXPECT_FALSE(monitor.latched());
}

TEST(MonitorOfMechanisms, stopsAllWhereOneThatMovesFallsSilent) {
  Monitor monitor = palletCell();
  monitor.take("left", kHome, kStanding, Duration(0), at(1));
  monitor.takePosition("pallet", 0.1, Duration(0), at(1));
  monitor.takePosition("pallet", 0.2, Duration(0), at(1.4));
  monitor.tick(at(1.9));
  EXPECT_FALSE(monitor.latched());
  ASSERT_TRUE(monitor.nextDeadline());
  monitor.tick(*monitor.nextDeadline());
  const auto stops = only<StopAll>(monitor.takeActions());
  ASSERT_EQ(stops.size(), 1U);
  EXPECT_EQ(stops[0].why, "pallet moved in its last report, which was measured more than 0.5 s ago.");
}

TEST(MonitorOfMechanisms, letsOneThatStandsBeSilent) {
  Monitor monitor = palletCell();
  monitor.take("left", kHome, kStanding, Duration(0), at(1));
  standAt(monitor, "pallet", kOut, at(1));
  monitor.tick(at(60));
  EXPECT_FALSE(monitor.latched());
  EXPECT_FALSE(monitor.nextDeadline());
}

TEST(MonitorOfMechanisms, stopsAgainOneThatMovesNevertheless) {
  Monitor monitor = palletCell();
  monitor.take("left", kT1, kStanding, Duration(0), at(1));
  for (int i = 0; i < 60; ++i) {
    const Instant now = at(1 + 0.02 * i);
    monitor.takePosition("pallet", kIn - 0.002 * i, Duration(0), now);
    monitor.take("left", kT1, kStanding, Duration(0), now);
    monitor.tick(now);
  }
  EXPECT_EQ(only<StopAll>(monitor.takeActions()).size(), 3U) << "at 1, 1.5 and 2 s";
}

TEST(MonitorOfMechanisms, dropsAndCountsWhatNoneCanTell) {
  Monitor monitor = palletCell();
  const double huge = std::numeric_limits<double>::max();
  for (const double wrong : {std::nan(""), std::numeric_limits<double>::infinity(), huge, -1001.0}) {
    monitor.takePosition("pallet", wrong, Duration(0), at(1));
  }
  EXPECT_EQ(monitor.status().counts.malformed, 4U);
  monitor.takePosition("pallet", 0.1, Duration(0), at(2));
  monitor.takePosition("pallet", 0.2, fromSeconds(1), at(2.5));
  EXPECT_EQ(monitor.status().counts.old, 1U);
  monitor.takePosition("table", 0.1, Duration(0), at(2));
  monitor.takePosition("left", 0.1, Duration(0), at(2));
  EXPECT_EQ(monitor.status().counts.unknown, 2U);
}

TEST(MonitorOfMechanisms, refusesOnesOfOneNameAndOnesWithoutBodies) {
  const WatchedRobot left{"left", leftBodies(), {}};
  EXPECT_FALSE(Monitor::of({left}, {}, {}, {{"left", palletBodies()}}));
  EXPECT_FALSE(Monitor::of({left}, {{"pallet", {Capsule{}}}}, {}, {{"pallet", palletBodies()}}));
  EXPECT_FALSE(Monitor::of({left}, {}, {}, {{"pallet", MechanismBodies(MotionAxis{}, {})}}));
}

}  // namespace
}  // namespace cobot_command::cell
