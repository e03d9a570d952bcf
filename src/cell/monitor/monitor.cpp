#include "cobot_command/cell/monitor/monitor.h"

#include <cmath>
#include <set>
#include <utility>

#include "monitor/monitor_parts.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

/// Empty: it is one.
std::string wrongIn(const MonitorSettings& settings) {
  const double stop_distance = settings.stop_distance.value_or(settings.margin / 2);
  for (const double value :
       {settings.margin, stop_distance, settings.standing_speed, settings.exact_within}) {
    if (!std::isfinite(value) || value < 0) {
      return fmt::format("A setting of the monitor is {}; all must be finite, and none negative.", value);
    }
  }
  if (stop_distance > settings.margin) {
    return fmt::format("The stop distance is {} m, but must be at most the margin, {} m.", stop_distance,
                       settings.margin);
  }
  if (settings.exact_within < settings.margin) {
    return fmt::format("Distances are exact within {} m, but must be exact within at least the margin, {} m.",
                       settings.exact_within, settings.margin);
  }
  if (settings.stale_after <= Duration::zero() || settings.period <= Duration::zero() ||
      settings.prompt <= Duration::zero()) {
    return "A time of the monitor is not valid; the ages of stale and of prompt data, and the period, must "
           "be above 0.";
  }
  return "";
}

/// Empty: nothing is.
std::string wrongWith(const std::vector<WatchedRobot>& robots, const std::vector<WatchedObstacle>& obstacles,
                      const std::vector<WatchedMechanism>& mechanisms) {
  std::set<std::string> names;
  const auto check = [&names](const std::string& name, bool bodies) -> std::string {
    if (!names.insert(name).second) {
      return fmt::format("Two objects in the cell are named \"{}\". Give each its own name.", name);
    }
    return bodies ? "" : fmt::format("\"{}\" has no bodies. Remove it, or define its shapes.", name);
  };
  for (const WatchedRobot& robot : robots) {
    std::set<std::string> parts;
    for (const FlangeCapsules& part : robot.may_carry) {
      if (parts.insert(part.name).second) continue;
      return fmt::format("\"{}\" may carry two parts that are named \"{}\". Give each its own name.",
                         robot.name, part.name);
    }
    std::string wrong = check(robot.name, !robot.bodies.bodies().empty());
    if (!wrong.empty()) return wrong;
  }
  for (const WatchedMechanism& mechanism : mechanisms) {
    std::string wrong = check(mechanism.name, mechanism.bodies.size() > 0);
    if (!wrong.empty()) return wrong;
  }
  for (const WatchedObstacle& obstacle : obstacles) {
    std::string wrong = check(obstacle.name, !obstacle.capsules.empty());
    if (!wrong.empty()) return wrong;
  }
  return "";
}

}  // namespace

Result<Monitor, MonitorRefusal> Monitor::of(std::vector<WatchedRobot> robots,
                                            const std::vector<WatchedObstacle>& obstacles,
                                            const MonitorSettings& settings,
                                            std::vector<WatchedMechanism> mechanisms) {
  std::string wrong = wrongIn(settings);
  if (wrong.empty()) wrong = wrongWith(robots, obstacles, mechanisms);
  if (!wrong.empty()) return refuse(MonitorRefusal{std::move(wrong)});
  return Monitor(std::make_unique<Parts>(std::move(robots), obstacles, settings, std::move(mechanisms)));
}

Monitor::Monitor(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Monitor::Monitor(Monitor&& other) noexcept = default;
Monitor& Monitor::operator=(Monitor&& other) noexcept = default;
Monitor::~Monitor() = default;

void Monitor::take(const std::string& robot, const arm::JointVector& joints,
                   const std::optional<arm::JointVector>& velocities, Duration age, Instant now) {
  parts_->take(robot, joints, velocities, age, now);
}

void Monitor::takePosition(const std::string& mechanism, double position, Duration age, Instant now) {
  parts_->takePosition(mechanism, position, age, now);
}

bool Monitor::setCarried(const std::string& robot, const std::optional<Carried>& parts) {
  return parts_->setCarried(robot, parts);
}

bool Monitor::setPermit(const std::string& mover, const std::optional<Permit>& permit) {
  return parts_->setPermit(mover, permit);
}

void Monitor::tick(Instant now) {
  parts_->tick(now);
}

ResetAnswer Monitor::reset(Instant now) {
  return parts_->reset(now);
}

std::vector<MonitorAction> Monitor::takeActions() {
  return parts_->takeActions();
}

MonitorStatus Monitor::status() const {
  return parts_->status();
}

std::vector<SeenBodies> Monitor::bodies() const {
  return parts_->bodies();
}

bool Monitor::latched() const {
  return parts_->latched();
}

std::vector<Breach> Monitor::breaches() const {
  return parts_->breaches();
}

std::optional<Instant> Monitor::nextDeadline() const {
  return parts_->nextDeadline();
}

}  // namespace cobot_command::cell
