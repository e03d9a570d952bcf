#include "paths/input_check.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;
using Finding = std::optional<Refusal>;

Refusal refusal(Reason reason, std::string message) {
  Refusal made;
  made.reason = reason;
  made.message = std::move(message);
  return made;
}

Finding checkFinite(bool finite, const char* what) {
  if (finite) {
    return std::nullopt;
  }
  return refusal(Reason::NotFinite,
                 fmt::format("{} is not finite (NaN or infinite): give finite numbers", what));
}

Finding checkPose(const arm::Pose& pose, const char* what) {
  if (auto found = checkFinite(pose.matrix().allFinite(), what)) {
    return found;
  }
  constexpr double kTolerance = 1e-6;
  const Eigen::Matrix3d& r = pose.linear();
  const double error = (r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (error <= kTolerance && r.determinant() > 0.0) {
    return std::nullopt;
  }
  return refusal(
      Reason::BadParameter,
      fmt::format("the orientation of {} is not a rotation (off by {:.3g}, allowed {:.0e}): give an "
                  "orthonormal, right-handed one",
                  what, error, kTolerance));
}

Finding checkRatio(double ratio, const char* what) {
  if (auto found = checkFinite(std::isfinite(ratio), what)) {
    return found;
  }
  if (ratio > 0.0 && ratio <= 1.0) {
    return std::nullopt;
  }
  return refusal(Reason::BadParameter,
                 fmt::format("{} is {:.6g} %, allowed above 0 up to 100 %: choose a speed in this range",
                             what, 100.0 * ratio));
}

Finding checkSpeed(const PathSpeed& speed) {
  if (const auto* ratio = std::get_if<SpeedRatio>(&speed)) {
    return checkRatio(ratio->value, "the speed");
  }
  const double value = std::get<TcpSpeed>(speed).metres_per_second;
  if (auto found = checkFinite(std::isfinite(value), "the speed")) {
    return found;
  }
  if (value > 0.0 && value <= kMaxTcpSpeed) {
    return std::nullopt;
  }
  return refusal(
      Reason::BadParameter,
      fmt::format("the speed is {:.6g} mm/s, allowed above 0 up to {:.0f} mm/s: choose a speed in this "
                  "range",
                  mToMm(value), mToMm(kMaxTcpSpeed)));
}

Finding checkRamp(Duration time_to_top_speed) {
  if (time_to_top_speed >= Duration::zero()) {
    return std::nullopt;
  }
  return refusal(Reason::BadParameter,
                 fmt::format("the time to top speed is {:.6g} ms, it must not be negative: give a time, or 0 "
                             "for the shortest that the arm allows",
                             1e3 * toSeconds(time_to_top_speed)));
}

Finding checkAngle(double angle) {
  if (auto found = checkFinite(std::isfinite(angle), "the arc angle")) {
    return found;
  }
  if (angle != 0.0 && std::abs(angle) <= kMaxArcAngle) {
    return std::nullopt;
  }
  return refusal(
      Reason::BadParameter,
      fmt::format("the arc angle is {:.6g} deg, allowed -360..360 deg except 0: choose an angle in "
                  "this range",
                  radToDeg(angle)));
}

/// The first finding of a list of checks that were all made.
Finding first(std::initializer_list<Finding> findings) {
  for (const Finding& finding : findings) {
    if (finding) {
      return finding;
    }
  }
  return std::nullopt;
}

Finding checkCommand(const Ptp& ptp) {
  const auto* joints = std::get_if<arm::JointVector>(&ptp.target);
  return first({joints ? checkFinite(joints->allFinite(), "the joint target")
                       : checkPose(std::get<PoseTarget>(ptp.target).pose, "the target"),
                checkRatio(ptp.speed_ratio, "the speed"), checkRamp(ptp.time_to_top_speed)});
}

Finding checkCommand(const Line& line) {
  return first(
      {checkPose(line.target, "the target"), checkSpeed(line.speed), checkRamp(line.time_to_top_speed)});
}

Finding checkCommand(const MovePtp& move) {
  const auto* joints = std::get_if<arm::JointVector>(&move.offset);
  return first({joints ? checkFinite(joints->allFinite(), "the joint offset")
                       : checkPose(std::get<PoseOffset>(move.offset).by, "the offset"),
                checkRatio(move.speed_ratio, "the speed"), checkRamp(move.time_to_top_speed)});
}

Finding checkCommand(const MoveLine& move) {
  return first(
      {checkPose(move.offset.by, "the offset"), checkSpeed(move.speed), checkRamp(move.time_to_top_speed)});
}

Finding checkCommand(const Circle& circle) {
  return first({checkPose(circle.via, "the arc point"), checkPose(circle.end, "the end"),
                circle.arc_angle ? checkAngle(*circle.arc_angle) : std::nullopt, checkSpeed(circle.speed),
                checkRamp(circle.time_to_top_speed)});
}

Finding checkCommand(const PLine& line) {
  const auto* joints = std::get_if<arm::JointVector>(&line.target);
  return first({joints ? checkFinite(joints->allFinite(), "the joint target")
                       : checkPose(std::get<arm::Pose>(line.target), "the target"),
                checkSpeed(line.speed), checkRamp(line.time_to_top_speed)});
}

Finding checkCommand(const MovePLine& move) {
  const auto* joints = std::get_if<arm::JointVector>(&move.offset);
  return first({joints ? checkFinite(joints->allFinite(), "the joint offset")
                       : checkPose(std::get<PoseOffset>(move.offset).by, "the offset"),
                checkSpeed(move.speed), checkRamp(move.time_to_top_speed)});
}

Finding checkRates(const Rates& rates, const char* what) {
  for (const double value : {rates.speed, rates.acceleration, rates.deceleration}) {
    if (auto found = checkFinite(std::isfinite(value), what)) {
      return found;
    }
    if (value <= 0.0) {
      return refusal(Reason::BadParameter,
                     fmt::format("{} is {:.6g}, it must be above 0: give a higher one", what, value));
    }
  }
  return std::nullopt;
}

Finding checkShape(const RampShape& ramps) {
  for (const double share : {ramps.up, ramps.down}) {
    if (!(share >= 0.0 && share <= 1.0)) {
      return refusal(Reason::BadParameter,
                     fmt::format("the jerk is {:.6g} %, allowed 0..100 %: choose one in "
                                 "this range",
                                 100.0 * share));
    }
  }
  return std::nullopt;
}

Finding checkPathRates(const PathRates& rates) {
  return first({checkRates(rates.way, "a speed or an acceleration of the translation"),
                checkRates(rates.turn, "a speed or an acceleration of the rotation"),
                checkShape(rates.ramps)});
}

Finding checkCommand(const JointMove& move) {
  return first({checkFinite(move.target.allFinite(), "the joint target"),
                checkRates(move.rates, "a speed or an acceleration"), checkShape(move.ramps)});
}

Finding checkCommand(const StraightMove& move) {
  return first({checkPose(move.target, "the target"), checkPathRates(move.rates)});
}

Finding checkCommand(const WristMove& move) {
  return first({checkFinite(move.target.allFinite(), "the joint target"), checkPathRates(move.rates)});
}

Finding checkCommand(const ArcMove& move) {
  return first({checkPose(move.via, "the arc point"), checkPose(move.target, "the target"),
                checkPathRates(move.rates)});
}

Finding checkPoint(const PvtJointPoint& point) {
  return first({checkFinite(point.position.allFinite(), "the position of a point"),
                checkFinite(point.velocity.allFinite(), "the velocity of a point")});
}

Finding checkPoint(const PvtPosePoint& point) {
  return first({checkPose(point.pose, "a point"),
                checkFinite(point.velocity.linear.allFinite() && point.velocity.angular.allFinite(),
                            "the velocity of a point")});
}

template <class Point>
Finding checkTimedPoint(const Point& point) {
  const double duration = point.duration;
  auto found = first({checkPoint(point), checkFinite(std::isfinite(duration), "the duration of a point")});
  if (found || duration >= kMinPvtDuration) {
    return found;
  }
  return refusal(
      Reason::BadParameter,
      fmt::format("the duration of a point is {:.6g} s, at least {:.3f} s is allowed: give it more "
                  "time",
                  duration, kMinPvtDuration));
}

Finding checkCommand(const Pvt& pvt) {
  return std::visit(
      [](const auto& points) -> Finding {
        for (const auto& point : points) {
          if (auto found = checkTimedPoint(point)) {
            return found;
          }
        }
        return std::nullopt;
      },
      pvt.points);
}

}  // namespace

Finding checkInput(const arm::JointVector& start, const Command& command, const Setting& setting) {
  return first({checkFinite(start.allFinite(), "the start posture"), checkPose(setting.base, "the base"),
                checkPose(setting.tcp, "the TCP"), checkRatio(setting.speed_override, "the project speed"),
                std::visit([](const auto& kind) { return checkCommand(kind); }, command)});
}

Finding targetOutsideLimits(const arm::ArmModel& arm, const arm::JointVector& target,
                            const Setting& setting) {
  const int joint = arm.firstJointOutsideLimits(target);
  if (joint < 0) {
    return std::nullopt;
  }
  const arm::JointLimit& limit = arm.limits()[static_cast<std::size_t>(joint)];
  return Refusal{
      Reason::JointLimit, 1.0, joint,
      setting.base.inverse() * arm::forwardKinematics(arm, target) * setting.tcp,
      fmt::format(
          "the target has J{} at {:.2f} deg, allowed {:.1f}..{:.1f} deg: choose a target inside the limits",
          joint + 1, radToDeg(target[joint]), radToDeg(limit.lower), radToDeg(limit.upper))};
}

Finding checkDuration(double seconds) {
  if (seconds <= kMaxDuration) {
    return std::nullopt;
  }
  const std::string found = std::isfinite(seconds) ? fmt::format("{:.6g} s", seconds) : "for ever";
  return refusal(Reason::BadParameter,
                 fmt::format("the motion would take {}, at most {:.0f} s are allowed: choose a higher speed "
                             "or a shorter time to top speed",
                             found, kMaxDuration));
}

}  // namespace cobot_command::motion
