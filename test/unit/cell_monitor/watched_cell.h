// The cell of demo A1 before a monitor.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cell_test_support.h"

#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

inline Instant at(double seconds) {
  return Instant(fromSeconds(seconds));
}

inline const arm::JointVector kHome = arm::toJointVector({0, -30, 120, 0, 90, 0});
inline const arm::JointVector kT1 = arm::toJointVector({0, 45, 60, -15, 90, 0});
inline const arm::JointVector kStanding = arm::JointVector::Zero();

inline const RobotBodies& leftBodies() {
  static const RobotBodies bodies = robotAt({-720, 122.3, 0, 0, 0, 0});
  return bodies;
}
inline const RobotBodies& rightBodies() {
  static const RobotBodies bodies = robotAt({720, -122.3, 0, 0, 0, 180});
  return bodies;
}

inline Monitor monitorOf(std::vector<WatchedRobot> robots, const MonitorSettings& settings = {},
                         const std::vector<WatchedObstacle>& obstacles = {}) {
  auto monitor = Monitor::of(std::move(robots), obstacles, settings);
  if (!monitor) throw std::runtime_error(monitor.error().message);
  return std::move(*monitor);
}

inline Monitor handover(const MonitorSettings& settings = {}) {
  return monitorOf({{"left", leftBodies(), {}}, {"right", rightBodies(), {}}}, settings);
}

/// Both stand there, and were measured now.
inline void stand(Monitor& monitor, const arm::JointVector& left, const arm::JointVector& right,
                  Instant now) {
  monitor.take("left", left, kStanding, Duration(0), now);
  monitor.take("right", right, kStanding, Duration(0), now);
  monitor.tick(now);
}

/// As `stand`, in a monitor that knows nothing of before: no speed follows from what was before.
inline PairStatus pairAt(const arm::JointVector& left, const arm::JointVector& right) {
  Monitor monitor = handover();
  stand(monitor, left, right, at(0));
  return monitor.status().pairs.front();
}

/// The way from home to T1, by its parts.
inline arm::JointVector onTheWay(double part) {
  return kHome + part * (kT1 - kHome);
}

/// Of two robots, but for what never moves; the slow way [m].
inline double trueDistance(const RobotBodies& one, const PlacedRobot& here, const RobotBodies& other,
                           const PlacedRobot& there) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < here.capsules.size(); ++i) {
    for (std::size_t j = 0; j < there.capsules.size(); ++j) {
      if (isFixed(one.bodies()[i]) && isFixed(other.bodies()[j])) continue;
      least = std::min(least, distanceBetween(here.capsules[i], there.capsules[j]));
    }
  }
  return least;
}
inline double trueDistance(const arm::JointVector& left, const arm::JointVector& right) {
  return trueDistance(leftBodies(), leftBodies().at(left), rightBodies(), rightBodies().at(right));
}

/// So that the left one, on its way to T1 with the right one there, is as far from it as that [m].
inline arm::JointVector leftAt(double distance) {
  double far = 0;
  double near = 1;
  while (near - far > 1e-12) {
    const double middle = 0.5 * (far + near);
    (pairAt(onTheWay(middle), kT1).distance > distance ? far : near) = middle;
  }
  return onTheWay(far);
}

template <class Action>
std::vector<Action> only(const std::vector<MonitorAction>& actions) {
  std::vector<Action> those;
  for (const MonitorAction& action : actions) {
    if (const auto* one = std::get_if<Action>(&action)) those.push_back(*one);
  }
  return those;
}

}  // namespace cobot_command::cell
