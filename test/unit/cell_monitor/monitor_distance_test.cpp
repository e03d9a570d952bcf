// How far robots are from each other, and how far they may have moved since (cell.md, M35).
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "watched_cell.h"
#include <gtest/gtest.h>

#include "cobot_command/cell/sweep/displacement.h"

namespace cobot_command::cell {
namespace {

TEST(MonitorDistance, isThatOfTheOracleAtTheStations) {
  EXPECT_NEAR(mToMm(pairAt(kHome, kHome).distance), 659, 1);
  EXPECT_NEAR(mToMm(pairAt(kHome, kT1).distance), 180, 1);
  EXPECT_NEAR(mToMm(pairAt(kT1, kHome).distance), 180, 1);
  EXPECT_NEAR(mToMm(pairAt(kT1, kT1).distance), -86, 1);
}

TEST(MonitorDistance, namesTheRobotsAndTheirNearestBodies) {
  const PairStatus pair = pairAt(kT1, kHome);
  EXPECT_TRUE(pair.known && pair.exact);
  EXPECT_EQ(pair.first, "left");
  EXPECT_EQ(pair.second, "right");
  const PlacedRobot left = leftBodies().at(kT1);
  const PlacedRobot right = rightBodies().at(kHome);
  const Nearest nearest = nearestOf(left.capsules, right.capsules);
  EXPECT_NEAR(pair.distance, nearest.distance, 1e-12);
  EXPECT_EQ(pair.first_body, leftBodies().bodies()[nearest.first].name);
  EXPECT_EQ(pair.second_body, rightBodies().bodies()[nearest.second].name);
}

TEST(MonitorDistance, isExactWhereverTheRobotsWereBefore) {
  RandomNumbers random(3);
  MonitorSettings settings;
  settings.exact_within = 5;
  Monitor monitor = handover(settings);
  for (int i = 1; i <= 500; ++i) {
    const arm::JointVector left = random.joints(3);
    const arm::JointVector right = random.joints(3);
    stand(monitor, left, right, at(i));
    const double distance = trueDistance(left, right);
    EXPECT_NEAR(monitor.status().pairs.front().distance, distance, 1e-12);
  }
}

TEST(MonitorDistance, isALowerBoundWhereTheRobotsAreFar) {
  RandomNumbers random(4);
  MonitorSettings settings;
  settings.exact_within = 0.2;
  Monitor monitor = handover(settings);
  int bounds = 0;
  for (int i = 1; i <= 500; ++i) {
    const arm::JointVector left = random.joints(3);
    const arm::JointVector right = random.joints(3);
    stand(monitor, left, right, at(i));
    const double distance = trueDistance(left, right);
    const PairStatus pair = monitor.status().pairs.front();
    EXPECT_LE(pair.distance, distance + 1e-12);
    if (pair.exact) continue;
    ++bounds;
    EXPECT_GT(pair.distance, 0.2);
    EXPECT_EQ(pair.first_body, "");
  }
  EXPECT_GT(bounds, 20);
  EXPECT_LT(bounds, 480);
}

TEST(MonitorDistance, isNotKnownBeforeBothRobotsWereHeard) {
  Monitor monitor = handover();
  monitor.tick(at(0));
  EXPECT_FALSE(monitor.status().pairs.front().known);
  monitor.take("left", kHome, kStanding, Duration(0), at(0));
  monitor.tick(at(0));
  EXPECT_FALSE(monitor.status().pairs.front().known);
  EXPECT_EQ(monitor.status().diagnosis, "right has not reported yet.");
}

TEST(MonitorDistance, keepsTheLeastEverAndWhenThatWas) {
  Monitor monitor = handover();
  stand(monitor, kHome, kHome, at(1));
  stand(monitor, kT1, kHome, at(2));
  stand(monitor, kHome, kHome, at(3));
  const PairStatus pair = monitor.status().pairs.front();
  EXPECT_NEAR(mToMm(pair.distance), 659, 1);
  EXPECT_NEAR(mToMm(pair.least), 180, 1);
  EXPECT_EQ(pair.least_at, at(2));
  EXPECT_EQ(pair.least_first_body, "link_5");
}

TEST(MonitorDistance, toAnObstacleIsWatchedButThatOfTheFixedBaseIsNot) {
  const RobotBodies& robot = leftBodies();
  const Capsule below{robot.base().translation(), robot.base().translation(), 0.01};
  Monitor monitor = monitorOf({{"left", robot, {}}}, {}, {{"table", {below}}});
  monitor.take("left", kHome, kStanding, Duration(0), at(0));
  monitor.tick(at(0));
  const PlacedRobot placed = robot.at(kHome);
  double distance = 1e9;
  for (std::size_t i = 0; i < placed.capsules.size(); ++i) {
    if (!isFixed(robot.bodies()[i])) {
      distance = std::min(distance, distanceBetween(placed.capsules[i], below));
    }
  }
  const PairStatus pair = monitor.status().pairs.front();
  EXPECT_EQ(pair.second, "table");
  EXPECT_NEAR(pair.distance, distance, 1e-12);
  EXPECT_EQ(pair.second_body, "table");
}

TEST(MonitorDistance, countsAllThatMayBeCarriedUntilItIsTold) {
  const FlangeCapsules bar{"bar", {{{-0.4, 0, 0}, {0.4, 0, 0}, 0.02}, {{0, -0.4, 0}, {0, 0.4, 0}, 0.02}}};
  Monitor monitor = monitorOf({{"left", leftBodies(), {bar}}, {"right", rightBodies(), {}}});
  stand(monitor, kT1, kHome, at(0));
  const double with =
      nearestOf(leftBodies().carrying({bar}).at(kT1).capsules, rightBodies().at(kHome).capsules).distance;
  EXPECT_NEAR(monitor.status().pairs.front().distance, with, 1e-12);
  EXPECT_LT(with, 0.17);
  EXPECT_FALSE(monitor.setCarried("left", Carried{"foo"}));
  EXPECT_FALSE(monitor.setCarried("foo", Carried{}));
  EXPECT_FALSE(monitor.setCarried("foo", std::nullopt));
  EXPECT_FALSE(monitor.setCarried("left", Carried{"bar", "foo"}));
  EXPECT_TRUE(monitor.setCarried("left", std::nullopt));
  EXPECT_FALSE(monitor.nextDeadline().has_value()) << "nothing has changed";
  EXPECT_TRUE(monitor.setCarried("left", Carried{}));
  ASSERT_TRUE(monitor.nextDeadline().has_value());
  monitor.tick(*monitor.nextDeadline());
  EXPECT_NEAR(mToMm(monitor.status().pairs.front().distance), 180, 1);
  EXPECT_TRUE(monitor.setCarried("left", Carried{}));
  EXPECT_FALSE(monitor.nextDeadline().has_value()) << "that is known";
  EXPECT_TRUE(monitor.setCarried("left", Carried{"bar"}));
  monitor.tick(at(1));
  EXPECT_NEAR(monitor.status().pairs.front().distance, with, 1e-12);
  EXPECT_TRUE(monitor.setCarried("left", Carried{}));
  EXPECT_TRUE(monitor.setCarried("left", std::nullopt)) << "nobody can tell any more";
  monitor.tick(at(2));
  EXPECT_NEAR(monitor.status().pairs.front().distance, with, 1e-12);
}

TEST(MonitorDistance, isThatOfTheLastLookUntilTheNextWhateverIsSetDownMeanwhile) {
  const FlangeCapsules bar{"bar", {{{-0.4, 0, 0}, {0.4, 0, 0}, 0.02}, {{0, -0.4, 0}, {0, 0.4, 0}, 0.02}}};
  Monitor monitor = monitorOf({{"left", leftBodies(), {bar}}, {"right", rightBodies(), {}}});
  stand(monitor, kT1, kHome, at(0));
  const PairStatus with = monitor.status().pairs.front();
  EXPECT_EQ(with.first_body, "bar");
  monitor.setCarried("left", Carried{});
  EXPECT_EQ(monitor.status().pairs.front().first_body, "bar");
  EXPECT_EQ(monitor.status().pairs.front().distance, with.distance);
  EXPECT_EQ(monitor.bodies().front().body_names.back(), "tool");
  monitor.tick(at(1));
  EXPECT_NE(monitor.status().pairs.front().first_body, "bar");
}

TEST(MonitorUncertainty, isNoneOfDataOfNowAndOfRobotsThatStand) {
  Monitor monitor = handover();
  monitor.take("left", kHome, arm::JointVector::Constant(1), Duration(0), at(0));
  monitor.take("right", kHome, kStanding, Duration(0), at(0));
  monitor.tick(at(0));
  EXPECT_EQ(monitor.status().pairs.front().uncertainty, 0);
  EXPECT_EQ(pairAt(kHome, kT1).uncertainty, 0);
}

double uncertaintyAt(double speed, double age) {
  Monitor monitor = handover();
  monitor.take("left", kHome, speed * arm::JointVector::Unit(0), fromSeconds(age / 2), at(10));
  monitor.take("right", kHome, kStanding, Duration(0), at(10));
  monitor.tick(at(10 + age / 2));
  return monitor.status().pairs.front().uncertainty;
}

TEST(MonitorUncertainty, growsWithTheAgeOfTheDataAndWithTheSpeed) {
  const double some = uncertaintyAt(0.5, 0.1);
  EXPECT_GT(some, 0.01);
  // One joint: its lever by its angle, with its sign or without it.
  EXPECT_NEAR(uncertaintyAt(1.0, 0.1), 2 * some, 1e-9);
  EXPECT_NEAR(uncertaintyAt(0.5, 0.2), 2 * some, 1e-9);
  EXPECT_NEAR(uncertaintyAt(-0.5, 0.1), some, 1e-9);
}

/// The least distance once each body has moved by its bound towards all others; the slow way, and by other
/// code.
double lowestOf(const PlacedRobot& left, const PlacedRobot& right, const arm::JointVector& widths) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < left.capsules.size(); ++i) {
    const std::size_t link = leftBodies().bodies()[i].link;
    const double moved = displacementBound(left.capsules[i], link, left.axes, widths);
    for (std::size_t j = 0; j < right.capsules.size(); ++j) {
      const std::size_t other = rightBodies().bodies()[j].link;
      if (isFixed(leftBodies().bodies()[i]) && isFixed(rightBodies().bodies()[j])) continue;
      const double others = displacementBound(right.capsules[j], other, right.axes, widths);
      lowest = std::min(lowest, distanceBetween(left.capsules[i], right.capsules[j]) - moved - others);
    }
  }
  return lowest;
}

TEST(MonitorUncertainty, isThatOfTheBodiesThatMayBeTheClosestByNow) {
  RandomNumbers random(29);
  MonitorSettings settings;
  settings.exact_within = 5;
  for (int i = 0; i < 1000; ++i) {
    const arm::JointVector left = random.joints(3);
    const arm::JointVector right = random.joints(3);
    const arm::JointVector speeds = random.joints(2);
    Monitor monitor = handover(settings);
    monitor.take("left", left, speeds, Duration(0), at(0));
    monitor.take("right", right, speeds, Duration(0), at(0));
    monitor.tick(at(0.1));
    const PairStatus pair = monitor.status().pairs.front();
    const double lowest = lowestOf(leftBodies().at(left), rightBodies().at(right), 0.1 * speeds.cwiseAbs());
    EXPECT_NEAR(pair.distance - pair.uncertainty, lowest, 1e-9);
  }
}

/// By how much robots came closer than they were measured, at most in parts of the uncertainty.
double largestPart(int motions, double age) {
  RandomNumbers random(23);
  double largest = 0;
  for (int i = 0; i < motions; ++i) {
    const arm::JointVector left = random.joints(3);
    const arm::JointVector right = random.joints(3);
    arm::JointVector speeds = random.joints(2);
    if (i % 2 == 0) speeds = speeds.cwiseProduct(arm::JointVector::Unit(i / 2 % 6));
    Monitor monitor = handover();
    monitor.take("left", left, speeds, Duration(0), at(0));
    monitor.take("right", right, i % 3 == 0 ? kStanding : speeds, Duration(0), at(0));
    monitor.tick(at(age));
    const PairStatus pair = monitor.status().pairs.front();
    if (pair.uncertainty == 0) continue;
    for (int k = 0; k < 20; ++k) {
      arm::JointVector parts = random.joints(1);
      if (random.coin()) parts = parts.cwiseSign();
      const arm::JointVector moved = age * speeds.cwiseProduct(parts);
      const double distance = trueDistance(left + moved, i % 3 == 0 ? right : right - moved);
      largest = std::max(largest, (pair.distance - distance) / pair.uncertainty);
    }
  }
  return largest;
}

TEST(MonitorUncertainty, boundsWhatMayHaveMovedAndHalfOfItWouldNotDo) {
  for (const double age : {0.01, 0.1, 0.45}) {
    const double part = largestPart(1000, age);
    EXPECT_LE(part, 1 + 1e-9) << age;
    EXPECT_GT(part, 0.5) << age;
  }
}

}  // namespace
}  // namespace cobot_command::cell
