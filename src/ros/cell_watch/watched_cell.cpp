#include "cell_watch/watched_cell.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/runtime/cell/cell_watch.h"

namespace cobot_command::ros_adapter {
namespace {

Result<std::vector<cell::WatchedMechanism>, std::string> mechanismsOf(const cell::Cell& cell) {
  std::vector<cell::WatchedMechanism> mechanisms;
  for (const cell::Mechanism& known : cell.mechanisms) {
    const cell::MotionAxis axis{known.axis == cell::Mechanism::Axis::Revolute, known.at, known.direction};
    auto bodies = cell::MechanismBodies::of(axis, known.shapes, cell.parameters.body_cell);
    if (!bodies) return refuse(fmt::format("mechanisms.{}: {}", known.name, bodies.error().message));
    mechanisms.push_back({known.name, std::move(*bodies)});
  }
  return mechanisms;
}

Result<std::vector<cell::WatchedObstacle>, std::string> obstaclesOf(const cell::Cell& cell) {
  std::vector<cell::WatchedObstacle> obstacles;
  for (const cell::Obstacle& known : cell.obstacles) {
    auto capsules = cell::capsulesOf(known.shapes, cell.parameters.body_cell);
    if (!capsules) return refuse(fmt::format("obstacles.{}: {}", known.name, capsules.error().message));
    obstacles.push_back({known.name, std::move(*capsules)});
  }
  return obstacles;
}

}  // namespace

Result<cell::Monitor, std::string> watchedCell(const cell::Cell& cell, cell::MonitorSettings::Mode mode,
                                               std::optional<double> stop_distance) {
  auto robots = runtime::watchedRobots(cell);
  if (!robots) return refuse(robots.error());
  auto mechanisms = mechanismsOf(cell);
  if (!mechanisms) return refuse(mechanisms.error());
  const auto obstacles = obstaclesOf(cell);
  if (!obstacles) return refuse(obstacles.error());
  cell::MonitorSettings settings;
  settings.margin = cell.parameters.margin;
  settings.mode = mode;
  settings.stop_distance = stop_distance;
  settings.exact_within = std::max(settings.exact_within, settings.margin);
  auto monitor = cell::Monitor::of(std::move(*robots), *obstacles, settings, std::move(*mechanisms));
  if (!monitor) return refuse(monitor.error().message);
  return std::move(*monitor);
}

}  // namespace cobot_command::ros_adapter
