#include "cobot_command/runtime/cell/cell_watch.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/cell/claims/cell_bodies.h"

namespace cobot_command::runtime {
namespace {

/// Wherever in its program: who carries what at the moment, only others could tell.
cell::Carried attachedBy(const cell::Robot& robot) {
  cell::Carried attached;
  for (const cell::Path& path : robot.program) {
    for (const cell::Step& step : path.steps) {
      if (!step.attach.empty()) attached.insert(step.attach);
    }
  }
  return attached;
}

/// Some more than its ratings, as measured ones are not smooth.
std::vector<double> mostSpeedsOf(const arm::ArmModel& arm) {
  constexpr double kOfRated = 1.1;
  std::vector<double> most;
  most.reserve(arm.limits().size());
  for (const arm::JointLimit& limit : arm.limits()) most.push_back(kOfRated * limit.max_velocity);
  return most;
}

Result<std::vector<cell::WatchedMechanism>, std::string> watchedMechanisms(const cell::Cell& cell) {
  std::vector<cell::WatchedMechanism> mechanisms;
  for (const cell::Mechanism& mechanism : cell.mechanisms) {
    auto bodies = cell::mechanismBodiesOf(cell.parameters, mechanism);
    if (!bodies) return refuse(fmt::format("mechanisms.{}: {}", mechanism.name, bodies.error().message));
    mechanisms.push_back({mechanism.name, std::move(*bodies)});
  }
  return mechanisms;
}

Result<std::vector<cell::WatchedObstacle>, std::string> watchedObstacles(const cell::Cell& cell) {
  std::vector<cell::WatchedObstacle> obstacles;
  for (const cell::Obstacle& obstacle : cell.obstacles) {
    auto capsules = cell::capsulesOf(obstacle.shapes, cell.parameters.body_cell);
    if (!capsules) return refuse(fmt::format("obstacles.{}: {}", obstacle.name, capsules.error().message));
    obstacles.push_back({obstacle.name, std::move(*capsules)});
  }
  return obstacles;
}

}  // namespace

Result<std::vector<cell::WatchedRobot>, std::string> watchedRobots(const cell::Cell& cell) {
  const auto parts = cell::partTreeOf(cell);
  if (!parts) return refuse("parts: " + parts.error().message);
  std::vector<cell::WatchedRobot> robots;
  for (const cell::Robot& robot : cell.robots) {
    auto bodies = cell::RobotBodies::fromUrdf(arm::ArmModel::urdfOf(robot.model), robot.base, robot.tool,
                                              cell.parameters.body_cell);
    if (!bodies) return refuse(fmt::format("robots.{}: {}", robot.name, bodies.error().message));
    robots.push_back({robot.name, std::move(*bodies), parts->bodiesOf(attachedBy(robot)),
                      mostSpeedsOf(*arm::ArmModel::named(robot.model))});
  }
  return robots;
}

Result<cell::Monitor, std::string> monitorOf(const cell::Cell& cell, cell::MonitorSettings::Mode mode,
                                             std::optional<double> stop_distance) {
  auto robots = watchedRobots(cell);
  if (!robots) return refuse(robots.error());
  auto mechanisms = watchedMechanisms(cell);
  if (!mechanisms) return refuse(mechanisms.error());
  const auto obstacles = watchedObstacles(cell);
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

}  // namespace cobot_command::runtime
