#include "cobot_command/blocks/follow_joint_trajectory.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/parameter_checks.h"
#include "trajectory/trajectory_plan.h"
#include "trajectory/trajectory_run.h"
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr std::size_t kMostPoints = 20000;
/// What a time may be; how long a motion may take is the planner's to say [s].
constexpr double kLongest = 86400;
constexpr double kMostAngle = 1000;      // [rad], and [rad/s]
constexpr double kMostTolerance = 1000;  // [rad]
constexpr double kLongestWait = 3600;    // [s]
/// Clocks of two computers differ, and a message takes its time.
constexpr double kLatest = 1;
/// From rest to rest, within the rounding of who plans [rad/s].
constexpr double kRest = 0.01;
/// The same of a place [rad].
constexpr double kSamePlace = 1e-6;

/// Empty: they are one for each joint, and each may be.
std::string faultOf(const std::vector<double>& values, const char* what, const char* unit) {
  if (values.size() != arm::kJointCount) {
    return fmt::format("it has {} {}; allowed: {}", values.size(), what, arm::kJointCount);
  }
  for (std::size_t joint = 0; joint < values.size(); ++joint) {
    if (isWithin(values[joint], -kMostAngle, kMostAngle)) continue;
    return fmt::format("J{} of its {} is {}; allowed: +-{} {}", joint + 1, what, values[joint], kMostAngle,
                       unit);
  }
  return "";
}

bool rests(const TrajectoryPoint& point) {
  return std::all_of(point.velocities.begin(), point.velocities.end(),
                     [](double velocity) { return std::abs(velocity) <= kRest; });
}

/// Empty: nothing is wrong with it by itself.
std::string faultOf(const TrajectoryPoint& point, bool with_velocities) {
  if (std::string fault = faultOf(point.positions, "positions", "rad"); !fault.empty()) return fault;
  if (point.velocities.empty() == with_velocities) {
    return "velocities are given in this point or in point 0, but not in both; allowed: velocities in all "
           "points, or in none";
  }
  return with_velocities ? faultOf(point.velocities, "velocities", "rad/s") : "";
}

Failure invalid(std::size_t index, const std::string& found) {
  TrajectoryReport report;
  report.error_index = static_cast<int>(index);
  return {own_error::kTrajectoryInvalid, fmt::format("point {}: {}", index, found), "",
          Detail(std::move(report))};
}

/// The first joint that has another value by more than `allowed`.
std::optional<std::size_t> jointApart(const std::vector<double>& a, const std::vector<double>& b,
                                      double allowed) {
  for (std::size_t joint = 0; joint < a.size(); ++joint) {
    if (std::abs(a[joint] - b[joint]) > allowed) return joint;
  }
  return std::nullopt;
}

/// Empty: it comes later than the one before it, or is the same one once more.
std::string faultBehind(const TrajectoryPoint& before, const TrajectoryPoint& point) {
  if (point.time > before.time) return "";
  if (point.time < before.time) {
    return fmt::format("time_from_start is {} s, and that of the point before it {} s; it must increase",
                       point.time, before.time);
  }
  constexpr const char* kFound =
      "it has the same time as the point before it, and J{} {}; allowed: no difference";
  if (const auto joint = jointApart(before.positions, point.positions, kSamePlace)) {
    return fmt::format(kFound, *joint + 1, "has another position");
  }
  if (const auto joint = jointApart(before.velocities, point.velocities, kRest)) {
    return fmt::format(kFound, *joint + 1, "has another velocity");
  }
  return "";
}

std::optional<Failure> checkTimes(const std::vector<TrajectoryPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double time = points[i].time;
    if (!isWithin(time, 0, kLongest)) {
      return invalid(i, fmt::format("time_from_start is {} s; allowed: 0..{} s", time, kLongest));
    }
    if (i == 0) continue;
    if (std::string fault = faultBehind(points[i - 1], points[i]); !fault.empty()) return invalid(i, fault);
  }
  const double last = points.back().time;
  if (last > 0 && last < kLeastTime) {
    return invalid(points.size() - 1,
                   fmt::format("the last time_from_start is {} s; allowed: at least {} s", last, kLeastTime));
  }
  return std::nullopt;
}

std::optional<Failure> checkPoints(const std::vector<TrajectoryPoint>& points) {
  if (points.empty()) return std::nullopt;
  if (points.size() > kMostPoints) {
    return Failure{own_error::kTrajectoryInvalid,
                   fmt::format("it has {} points; allowed: {}", points.size(), kMostPoints), ""};
  }
  const bool with_velocities = !points.front().velocities.empty();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::string fault = faultOf(points[i], with_velocities); !fault.empty()) return invalid(i, fault);
  }
  if (auto failure = checkTimes(points)) return failure;
  if (points.front().time <= 0 && !rests(points.front())) {
    return invalid(
        0, "it has time 0 and a velocity; allowed: velocity 0, because the robot is at standstill there");
  }
  if (!rests(points.back())) {
    return invalid(points.size() - 1, "it is the last point and has a velocity; allowed: velocity 0");
  }
  return std::nullopt;
}

bool areTolerances(const SixValues& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return isWithin(value, -kMostTolerance, kMostTolerance); });
}

Failure cannotPlan(const PlanningScene& scene) {
  if (scene.arm == nullptr) return {own_error::kNoModel, "", ""};
  return {own_error::kStartUnknown, scene.why_unknown, ""};
}

}  // namespace

ErrorTable FollowJointTrajectoryGoal::errors() {
  return ErrorTable()
      .instead({{own_error::kNotAtTarget, own_error::kGoalTolerance}})
      .anyCommand()
      .turn()
      .underInterface()
      .inCell()
      .condition(motion_error::kOtherBlockBusy, "cannot occur through ROS: a trajectory always takes over")
      .condition(own_error::kBufferModeUnknown, "cannot occur through ROS, which has no such field here")
      .condition(own_error::kOrphanMoves, "cannot occur through ROS: a trajectory always takes over")
      .shared({motion_error::kReceiveTag, motion_error::kMotionFailed, own_error::kJointLimit,
               own_error::kJointSpeed, own_error::kPlanningBudget, own_error::kNoFreeTag, own_error::kTagLost,
               own_error::kStoppedElsewhere})
      .shared(own_error::kNotPlannable,
              "planning: refused for another reason than those above, for example a duration above 3 h")
      .shared(own_error::kStartUnknown,
              "the position of the robot is unknown: no status stream, or the robot is in a motion, or "
              "paused in a motion, whose end is unknown")
      .shared(own_error::kNoModel, "the command layer has no model of the arm")
      .row(own_error::kTrajectoryInvalid, "Trajectory invalid", "Correct the trajectory",
           "a point does not have six positions, or only some points have velocities; times do not increase "
           "(the same point may occur twice), or the last one is below 25 ms or above one day; the first "
           "point, with time 0, or the last one is not at rest; a tolerance or a time is not a number in its "
           "range; there are more points than one PVT takes; or a point less than 25 ms from its neighbours "
           "is off the path without it")
      .row(own_error::kJointNames, "Joint names wrong", "Name each joint of the robot once, in any order",
           "joint_names of the trajectory omit a joint of this robot, list one twice, or list an unknown "
           "one; or a tolerance is for an unknown joint")
      .row(own_error::kStampOld, "Trajectory should have begun", "Send it earlier, or with the stamp zero",
           "the stamp of the trajectory's header is not zero, and more than 1 s ago")
      .row(own_error::kNotAtStart, "Robot is not where the trajectory starts",
           "Plan the trajectory from the current position of the robot, or give its first point a time to "
           "get there",
           "the first point has time 0, and a joint is further from it than its path tolerance, or than 1 "
           "deg if none is given")
      .row(own_error::kPathTolerance, "Path tolerance violated",
           "Find out why the robot does not follow its trajectory, or allow a larger path_tolerance",
           "the status stream showed a joint further than its path tolerance from every position that the "
           "trajectory has from 0.5 s ago onward; the robot is sent a stop command")
      .row(own_error::kGoalTolerance, "Goal tolerance violated",
           "Find out why the robot does not reach its goal, or allow a larger goal_tolerance or "
           "goal_time_tolerance",
           "the controller reported the end of the trajectory, and until goal_time_tolerance later the "
           "status stream showed a joint further from its goal than its goal tolerance, or still in motion");
}

GoalTraits traitsOf(const FollowJointTrajectoryGoal& goal) {
  GoalTraits traits;
  traits.buffer_mode = bufferModeOf(goal.buffer_mode);
  traits.may_move = true;
  traits.needs_plan = true;
  return traits;
}

std::vector<Failure> check(const FollowJointTrajectoryGoal& goal) {
  ParameterChecks checks;
  checks.bufferMode(goal.buffer_mode);
  std::vector<Failure> failures = std::move(checks).violations();
  const auto require = [&](bool satisfied, int id, const std::string& found) {
    if (!satisfied) failures.push_back({id, found, ""});
  };
  if (goal.names_fault.empty()) {
    if (auto failure = checkPoints(goal.points)) failures.push_back(std::move(*failure));
  }
  require(areTolerances(goal.path_tolerance) && areTolerances(goal.goal_tolerance),
          own_error::kTrajectoryInvalid,
          fmt::format("a tolerance is not a number within +-{} rad", kMostTolerance));
  require(
      isWithin(goal.goal_time_tolerance, 0, kLongestWait), own_error::kTrajectoryInvalid,
      fmt::format("goal_time_tolerance is {} s; allowed: 0..{} s", goal.goal_time_tolerance, kLongestWait));
  require(!(goal.starts_in > kLongestWait || std::isnan(goal.starts_in)), own_error::kTrajectoryInvalid,
          fmt::format("it would begin in {:.1f} s; allowed: up to {} s", goal.starts_in, kLongestWait));
  require(goal.names_fault.empty(), own_error::kJointNames, goal.names_fault);
  require(!(goal.starts_in < -kLatest), own_error::kStampOld,
          fmt::format("its stamp is {:.3f} s old; allowed: up to {} s", -goal.starts_in, kLatest));
  return failures;
}

Outcome plan(const FollowJointTrajectoryGoal& goal, const PlanningScene& scene) {
  constexpr Block kThis = kBlock<FollowJointTrajectoryGoal>;
  Outcome outcome;
  TrajectoryReport report;
  if (goal.points.empty()) {
    report.plan = std::make_shared<const TrajectoryPlan>();
  } else if (scene.arm == nullptr || !scene.start || !scene.start->joints) {
    return toRejection(kThis, {cannotPlan(scene)});
  } else {
    const auto planned = planTrajectory(goal, scene);
    if (!planned) return toRejection(kThis, {planned.error()});
    report.plan = *planned;
    if (report.plan->motion) {
      outcome.planned = fromSeconds(toSeconds(report.plan->motion->duration()) / scene.start->speed_override);
    }
  }
  outcome.detail = Detail(std::move(report));
  return outcome;
}

std::unique_ptr<Run> runOf(const FollowJointTrajectoryGoal& goal, GoalId id, const Outcome& planned,
                           Instant now) {
  return std::make_unique<TrajectoryRun>(goal, id, planned, now);
}

}  // namespace cobot_command::blocks
