#include "pvt/pvt_points.h"

#include <algorithm>
#include <string>
#include <vector>

#include "motion_refusal.h"
#include "pvt/pvt_knots.h"
#include <fmt/format.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

constexpr motion::PvtRoom kHalf{0.5 * motion::PvtRoom().position, 0.5 * motion::PvtRoom().speed};

std::string textOf(const motion::PvtOffence& offence, const arm::JointLimit& limit) {
  if (offence.reason == motion::Refusal::Reason::JointSpeed) {
    return fmt::format(
        "would need {:.2f} deg/s, rated {:.1f} deg/s: choose a lower speed, or lower accelerations",
        radToDeg(offence.found), radToDeg(limit.max_velocity));
  }
  return fmt::format("would reach {:.2f} deg, allowed {:.1f}..{:.1f} deg: choose another target",
                     radToDeg(offence.found), radToDeg(limit.lower), radToDeg(limit.upper));
}

}  // namespace

PathRefusal toRefusal(const motion::PvtOffence& offence, const PathPlan& plan, Duration time,
                      const arm::ArmModel& arm) {
  const PlannedPoint& point = plan.points()[plan.placeAt(time).point];
  const arm::JointLimit& limit = arm.limits()[static_cast<std::size_t>(offence.joint)];
  PathRefusal made{errorIdOf(offence.reason), point.index, offence.joint,
                   fmt::format("sent as a PVT, {:.3f} s after the start of the point J{} {}",
                               toSeconds(time - point.start), offence.joint + 1, textOf(offence, limit))};
  made.where = arm::forwardKinematics(arm, offence.joints) * point.moved_frame;
  return made;
}

std::optional<PathRefusal> checkAsPvt(const PathPlan& plan, std::size_t first, std::size_t from,
                                      const arm::ArmModel& arm) {
  const std::vector<PvtKnot> knots = knotsOf(plan, first, plan.points().size() - 1, motion::kLeastSegment);
  const auto begin = std::find_if(knots.begin() + 1, knots.end(),
                                  [from](const PvtKnot& knot) { return knot.point >= from; }) -
                     1;
  const motion::PvtJointPoint start = pvtPointAt(plan, begin->time, *begin);
  motion::JointState state{start.position, start.velocity};
  for (auto knot = begin + 1; knot < knots.end(); ++knot) {
    const Duration before = (knot - 1)->time;
    const motion::PvtJointPoint point = pvtPointAt(plan, before, *knot);
    if (const auto offence = motion::checkPvtSegment(arm, state, point, kHalf)) {
      return toRefusal(*offence, plan, before + fromSeconds(offence->time), arm);
    }
    state = {point.position, point.velocity};
  }
  return std::nullopt;
}

}  // namespace cobot_command::path
