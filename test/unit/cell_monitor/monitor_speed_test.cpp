// Many robots, and how long one look at them takes (cell.md, P8).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "watched_cell.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

struct Hall {
  Monitor monitor;
  std::vector<RobotBodies> bodies;
};

std::string nameOf(int robot) {
  return "robot_" + std::to_string(robot);
}

/// In rows of eight, each as far from its neighbours as that [mm].
Hall hallOf(int count, double apart) {
  std::vector<WatchedRobot> robots;
  std::vector<RobotBodies> bodies;
  robots.reserve(static_cast<std::size_t>(count));
  bodies.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const int row = i / 8;
    bodies.push_back(robotAt({apart * (i % 8), apart * row, 0, 0, 0, 45.0 * i}));
    robots.push_back({nameOf(i), bodies.back(), {}});
  }
  MonitorSettings settings;
  settings.mode = MonitorSettings::Mode::Warn;
  return {monitorOf(std::move(robots), settings), std::move(bodies)};
}

/// The middle one of many times for a tick with new data of each robot [ms].
double millisecondsOfTick(Hall& hall) {
  using Clock = std::chrono::steady_clock;
  RandomNumbers random(5);
  std::vector<double> times;
  for (int tick = 1; tick <= 200; ++tick) {
    for (std::size_t i = 0; i < hall.bodies.size(); ++i) {
      const double part = 0.5 + 0.5 * std::sin(0.03 * tick + static_cast<double>(i));
      hall.monitor.take(nameOf(static_cast<int>(i)), onTheWay(part), random.joints(0.5), Duration(0),
                        at(0.02 * tick));
    }
    const auto begin = Clock::now();
    hall.monitor.tick(at(0.02 * tick + 0.01));
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    static_cast<void>(hall.monitor.takeActions());
  }
  std::nth_element(times.begin(), times.begin() + 100, times.end());
  return times[100];
}

TEST(MonitorOfMany, looksAtAllPairsOf32Robots) {
  Hall hall = hallOf(32, 1200);
  RandomNumbers random(6);
  std::vector<PlacedRobot> placed;
  for (std::size_t i = 0; i < hall.bodies.size(); ++i) {
    const arm::JointVector joints = random.joints(3);
    placed.push_back(hall.bodies[i].at(joints));
    hall.monitor.take(nameOf(static_cast<int>(i)), joints, kStanding, Duration(0), at(1));
  }
  hall.monitor.tick(at(1));
  const MonitorStatus status = hall.monitor.status();
  ASSERT_EQ(status.pairs.size(), 496u);
  std::size_t pair = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    for (std::size_t j = i + 1; j < placed.size(); ++j, ++pair) {
      const double distance = trueDistance(hall.bodies[i], placed[i], hall.bodies[j], placed[j]);
      EXPECT_LE(status.pairs[pair].distance, distance + 1e-12);
      if (distance < 1.0) {
        EXPECT_NEAR(status.pairs[pair].distance, distance, 1e-12);
      }
      EXPECT_EQ(status.pairs[pair].breached, distance < 0.020);
    }
  }
}

// Five times, as machines are busy, and builds have assertions and sanitizers; what is reached is printed.
TEST(MonitorOfMany, areLookedAtWithinFiveTimesTheGoal) {
  for (const auto& [count, goal] : {std::pair<int, double>{3, 0.1}, std::pair<int, double>{32, 2.0}}) {
    for (const double apart : {1000.0, 1400.0, 2000.0}) {
      Hall hall = hallOf(count, apart);
      const double milliseconds = millisecondsOfTick(hall);
      std::printf("%d robots, %.0f mm apart: %.4f ms (goal %.1f)\n", count, apart, milliseconds, goal);
      EXPECT_LT(milliseconds, 5 * goal);
    }
  }
}

}  // namespace
}  // namespace cobot_command::cell
