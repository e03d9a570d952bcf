#include "pvt/pvt_points.h"

#include <cmath>
#include <string>

#include "motion_refusal.h"
#include "pvt/pvt_phases.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

constexpr motion::PvtRoom kHalf{0.5 * motion::PvtRoom().position, 0.5 * motion::PvtRoom().speed};

/// As it is sent: five decimals of a degree.
double sentDegrees(double radians) {
  constexpr double kDecimals = 1e5;
  return std::round(radToDeg(radians) * kDecimals) / kDecimals;
}

arm::JointVector asSent(const arm::JointVector& joints) {
  return joints.unaryExpr([](double radians) { return degToRad(sentDegrees(radians)); });
}

std::string textOf(const motion::PvtOffence& offence, const arm::JointLimit& limit) {
  if (offence.reason == motion::Refusal::Reason::JointSpeed) {
    return fmt::format(
        "would need {:.2f} deg/s, rated {:.1f} deg/s: choose a lower speed, or lower accelerations",
        radToDeg(offence.found), radToDeg(limit.max_velocity));
  }
  return fmt::format("would reach {:.2f} deg, allowed {:.1f}..{:.1f} deg: choose another target",
                     radToDeg(offence.found), radToDeg(limit.lower), radToDeg(limit.upper));
}

/// The first on the phase.
std::optional<PathRefusal> checkPhase(const PathPlan& plan, const PvtPhase& phase, const arm::ArmModel& arm) {
  Duration before = phase.begin;
  const motion::PvtJointPoint begin = pvtPointAt(plan, before, before);
  motion::JointState state{begin.position, begin.velocity};
  for (const Duration time : segmentsOf(phase, motion::kLeastSegment)) {
    const motion::PvtJointPoint point = pvtPointAt(plan, before, time);
    if (const auto offence = motion::checkPvtSegment(arm, state, point, kHalf)) {
      return toRefusal(*offence, plan, before + fromSeconds(offence->time), arm);
    }
    before = time;
    state = {point.position, point.velocity};
  }
  return std::nullopt;
}

}  // namespace

motion::PvtJointPoint pvtPointAt(const PathPlan& plan, Duration before, Duration time) {
  const motion::JointState state = plan.at(time);
  return {asSent(state.position), asSent(state.velocity), toSeconds(time - before)};
}

PathRefusal toRefusal(const motion::PvtOffence& offence, const PathPlan& plan, Duration time,
                      const arm::ArmModel& arm) {
  const PlannedPoint& point = plan.points()[plan.placeAt(time).point];
  const arm::JointLimit& limit = arm.limits()[static_cast<std::size_t>(offence.joint)];
  PathRefusal made{errorIdOf(offence.reason), point.index, offence.joint,
                   fmt::format("sent as a PVT, {:.3f} s behind the start of the point J{} {}",
                               toSeconds(time - point.start), offence.joint + 1, textOf(offence, limit))};
  made.where = arm::forwardKinematics(arm, offence.joints) * point.moved_frame;
  return made;
}

std::optional<PathRefusal> checkAsPvt(const PathPlan& plan, std::size_t first, std::size_t from,
                                      const arm::ArmModel& arm) {
  for (const PvtPhase& phase : phasesOf(plan, first, plan.points().size() - 1, motion::kLeastSegment)) {
    if (phase.point < from) continue;
    if (auto refusal = checkPhase(plan, phase, arm)) return refusal;
  }
  return std::nullopt;
}

}  // namespace cobot_command::path
