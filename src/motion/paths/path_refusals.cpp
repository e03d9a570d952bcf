#include "paths/path_refusals.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

using Reason = Refusal::Reason;

/// Puts the place in front of `text`.
Refusal refusalAt(const TimedPath& timed, double progress, Reason reason, int joint,
                  const std::string& text) {
  Refusal refusal;
  refusal.reason = reason;
  refusal.at = progress;
  refusal.joint = joint;
  refusal.point = timed.base.inverse() * timed.postures.tcpAt(progress);
  const Eigen::Vector3d place = refusal.point.translation();
  refusal.message =
      fmt::format("at {:.1f} % of the {} (X {:.1f} mm, Y {:.1f} mm, Z {:.1f} mm) {}", 100.0 * progress,
                  timed.name, mToMm(place.x()), mToMm(place.y()), mToMm(place.z()), text);
  return refusal;
}

const arm::JointLimit& limitOf(const TimedPath& timed, int joint) {
  return timed.postures.arm().limits()[static_cast<std::size_t>(joint)];
}

/// The share of the asked speed, in the unit in which it was asked, rounded down so that it does.
std::string speedAdvice(const AskedSpeed& asked, double share) {
  if (asked.unit == nullptr) {
    return fmt::format("{:.2f} times the time is sufficient: give it more time, or choose another path",
                       std::ceil(100.0 / share) / 100.0);
  }
  const double usable = std::floor(10.0 * asked.value * share) / 10.0;
  if (usable <= 0.0) {
    return fmt::format("no useful speed in {} is slow enough: {}", asked.unit, asked.otherwise);
  }
  return fmt::format("at most {:.1f} {} is possible: choose a lower speed or another path", usable,
                     asked.unit);
}

}  // namespace

Refusal reachRefusal(const TimedPath& timed, double progress, Reason reason) {
  if (reason == Reason::PoseBits) {
    return refusalAt(
        timed, progress, reason, -1,
        fmt::format(
            "the point can be reached, but not with {}, which a {} keeps: choose another start posture, "
            "or PTP",
            timed.postures.kept(), timed.name));
  }
  return refusalAt(
      timed, progress, reason, -1,
      fmt::format("no posture reaches the point (nominal reach {:.0f} mm; or it is too close to the "
                  "first axis): choose another target, or "
                  "check base and TCP",
                  mToMm(timed.postures.arm().ratings().reach)));
}

Refusal jointLimitRefusal(const TimedPath& timed, double progress, int joint, double found) {
  const arm::JointLimit& limit = limitOf(timed, joint);
  return refusalAt(
      timed, progress, Reason::JointLimit, joint,
      fmt::format("J{} would reach {:.2f} deg, allowed {:.1f}..{:.1f} deg: choose another target or "
                  "start posture",
                  joint + 1, radToDeg(found), radToDeg(limit.lower), radToDeg(limit.upper)));
}

Refusal singularRefusal(const TimedPath& timed, double progress, const arm::JointVector& joints) {
  const arm::SingularityDistance distance = timed.postures.singularityDistance(joints);
  int joint = 4;
  std::string which = fmt::format("J5 = {:.2f} deg, wrist straight", radToDeg(joints[4]));
  if (distance.elbow <= distance.wrist) {
    joint = 2;
    which = fmt::format("J3 = {:.2f} deg, elbow straight", radToDeg(joints[2]));
  }
  if (distance.shoulder <= std::min(distance.elbow, distance.wrist)) {
    joint = 0;
    which = fmt::format("wrist {:.1f} mm from the shoulder's cylinder", mToMm(distance.shoulder));
  }
  return refusalAt(
      timed, progress, Reason::Singular, joint,
      fmt::format(
          "the arm runs into a singularity ({}), where a {} cannot continue: choose a path around it, or PTP",
          which, timed.name));
}

std::optional<Refusal> otherPosture(const arm::JointVector& end, const arm::JointVector& target,
                                    const arm::Pose& point) {
  constexpr double kSame = 1e-6;
  Eigen::Index joint = 0;
  if ((end - target).cwiseAbs().maxCoeff(&joint) <= kSame) return std::nullopt;
  return Refusal{
      Reason::PoseBits, 1.0, static_cast<int>(joint), point,
      fmt::format("the straight line to the target ends with J{} at {:.2f} deg, the target has it at "
                  "{:.2f} deg: choose a target in the posture of the start, or PTP",
                  joint + 1, radToDeg(end[joint]), radToDeg(target[joint]))};
}

Refusal jointSpeedRefusal(const TimedPath& timed, const SpeedOffence& offence) {
  return refusalAt(timed, offence.progress, Reason::JointSpeed, offence.joint,
                   fmt::format("J{} would need {:.1f} deg/s, rated {:.1f} deg/s; {}", offence.joint + 1,
                               radToDeg(offence.needed), radToDeg(limitOf(timed, offence.joint).max_velocity),
                               speedAdvice(timed.speed, offence.usable_share)));
}

}  // namespace cobot_command::motion
