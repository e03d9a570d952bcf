#include "cobot_command/blocks/ways_back/return_to_primary.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shared/parameter_checks.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::blocks {
namespace {

constexpr double kReturnSpeed = 10;   // [%]
constexpr int kTimeToTopSpeed = 500;  // [ms]

bool isPtp(const ReturnToPrimaryGoal& goal) {
  return goal.trajectory_mode == static_cast<int>(ReturnTrajectory::Ptp);
}

bool isToTheEnd(const ReturnToPrimaryGoal& goal) {
  return goal.return_mode == static_cast<int>(ReturnMode::EndPosition);
}

/// Nothing: it has none.
std::optional<ReturnTarget> targetOf(const ReturnToPrimaryGoal& goal) {
  if (!goal.place) return std::nullopt;
  return isToTheEnd(goal) ? goal.place->segment_end : std::optional(goal.place->interrupted);
}

void checkPlace(ParameterChecks& checks, const ReturnToPrimaryGoal& goal) {
  checks.require(goal.place.has_value(), own_error::kInterruption, "nothing is interrupted");
  if (!goal.place) return;
  const auto target = targetOf(goal);
  checks.require(target.has_value(), return_error::kReturnMode,
                 "return_mode is 1 (END_POSITION), and the interrupted motion has no known end: use 0 "
                 "(INTERRUPT_POSITION)");
  const bool is_limited = goal.distance_limit > 0 && target;
  checks.require(!is_limited || target->distance_mm <= goal.distance_limit, return_error::kTooFar,
                 fmt::format("the TCP is {:.1f} mm away; allowed by distance_limit: {} mm",
                             target ? target->distance_mm : 0.0, goal.distance_limit));
  const auto& difference = goal.place->difference;
  if (difference && !goal.allow_differences) {
    checks.require(false, difference->error_id, difference->found);
  }
}

}  // namespace

ErrorTable ReturnToPrimaryGoal::errors() {
  return ErrorTable()
      .anyCommand()
      .underInterface()
      .inCell()
      .motion()
      .shared({own_error::kNotListening, own_error::kEmergencyStop, own_error::kRobotError,
               own_error::kStopNotConfirmed, own_error::kOrphanMoves, own_error::kBaseUnknown})
      .shared(motion_error::kOtherBlockBusy,
              "another command is Busy, or the robot moves: this motion is never queued")
      .condition(own_error::kNotPlannable,
                 "cannot occur: within the ranges there is no other reason to refuse")
      .condition(own_error::kBaseUnknown,
                 "LINEAR, and the active base is defined in the project and its value is unknown")
      .shared(motion_error::kSpeedRangePercent, "speed is negative or above 100; 0 means 10 %")
      .shared(own_error::kNotFinite, "speed or distance_limit is NaN")
      .shared(own_error::kCoordinateRange, "distance_limit is negative or above 100000 mm")
      .row(own_error::kInterruption, "Nothing is interrupted", "Use the service interrupt first",
           "no motion was interrupted by the service interrupt, or it has continued or ended since")
      .row(return_error::kTooFar, "Limit exceeded",
           "Move closer to the return position, or raise distance_limit",
           "the TCP is further away than distance_limit")
      .row(return_error::kToolDiffers, "The TCP differs from that of the interruption",
           "Set it as it was (change_tcp), or give allow_differences",
           "the active TCP is not the one at the interruption, without allow_differences")
      .row(return_error::kLoadDiffers, "The load differs from that of the interruption",
           "Set it as it was (change_load, change_tcp), or give allow_differences",
           "the mass of the tool, or of its load, is not the one at the interruption, without "
           "allow_differences")
      .row(return_error::kFrameDiffers, "The base differs from that of the interruption",
           "Set it as it was (change_base), or give allow_differences",
           "the active base is not the one at the interruption, without allow_differences")
      .row(return_error::kReturnMode, "Return mode invalid", kSetInRange,
           "return_mode is neither 0 (INTERRUPT_POSITION) nor 1 (END_POSITION); or it is 1, and the robot "
           "was in no motion, or in a path, which has no such end")
      .row(return_error::kTrajectoryMode, "Trajectory mode invalid", kSetInRange,
           "trajectory_mode is neither 1 (LINEAR) nor 2 (PTP)");
}

GoalTraits traitsOf(const ReturnToPrimaryGoal& goal) {
  GoalTraits traits;
  traits.awaits_motion = true;
  traits.may_move = true;
  traits.needs_standstill = true;
  traits.needs_base = !isPtp(goal);
  return traits;
}

std::vector<Failure> check(const ReturnToPrimaryGoal& goal) {
  ParameterChecks checks;
  const bool is_number = !std::isnan(goal.speed) && !std::isnan(goal.distance_limit);
  checks.require(is_number, own_error::kNotFinite,
                 fmt::format("speed is {}, distance_limit {}", goal.speed, goal.distance_limit));
  checks.require(std::isnan(goal.speed) || isWithin(goal.speed, 0, 100), motion_error::kSpeedRangePercent,
                 fmt::format("speed is {}; allowed: 0..100 %", goal.speed));
  checks.require(
      std::isnan(goal.distance_limit) || isWithin(goal.distance_limit, 0, arm::kMaxCoordinate),
      own_error::kCoordinateRange,
      fmt::format("distance_limit is {}; allowed: 0..{} mm", goal.distance_limit, arm::kMaxCoordinate));
  checks.require(goal.return_mode == 0 || isToTheEnd(goal), return_error::kReturnMode,
                 fmt::format("return_mode is {}", goal.return_mode));
  checks.require(goal.trajectory_mode == static_cast<int>(ReturnTrajectory::Linear) || isPtp(goal),
                 return_error::kTrajectoryMode, fmt::format("trajectory_mode is {}", goal.trajectory_mode));
  checkPlace(checks, goal);
  return std::move(checks).violations();
}

/// The controller takes whole percents.
Order orderOf(const ReturnToPrimaryGoal& goal, const arm::Pose& base) {
  const ReturnTarget target = *targetOf(goal);
  script::MotionOptions options;
  options.speed = std::max(1, static_cast<int>(std::lround(goal.speed == 0 ? kReturnSpeed : goal.speed)));
  options.accel_time = kTimeToTopSpeed;
  script::DataFormat format;
  if (!isPtp(goal)) {
    return moveOrder(script::Line{format, arm::toControllerPose(base.inverse() * target.tcp), options});
  }
  format.target = script::DataFormat::Target::Joint;
  return moveOrder(script::Ptp{format, arm::toControllerJoints(target.joints), options, std::nullopt});
}

}  // namespace cobot_command::blocks
