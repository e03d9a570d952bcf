#include "cobot_command/path/path_rest.h"

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::path {
namespace {

/// Below that a circle through three places on it is not well known [m].
constexpr double kLeastArc = 1e-3;

/// Where half of the way is done that is left behind `time`.
Duration halfOfTheRest(const motion::Trajectory& motion, Duration time) {
  const double half = (motion.progress(time) + 1.0) / 2.0;
  Duration before = time;
  Duration behind = motion.duration();
  while (behind - before > std::chrono::milliseconds(1)) {
    const Duration middle = before + (behind - before) / 2;
    (motion.progress(middle) < half ? before : behind) = middle;
  }
  return behind;
}

}  // namespace

PlannedPoint restOf(const PlannedPoint& point, Duration time, const arm::ArmModel& arm) {
  PlannedPoint rest = point;
  const auto* const arc = std::get_if<motion::ArcMove>(&point.command);
  if (arc == nullptr || time <= Duration::zero()) return rest;
  const motion::Trajectory& motion = *point.motion;
  if ((1.0 - motion.progress(time)) * motion.tcpWay() < kLeastArc) {
    rest.point.interpolation = static_cast<int>(Interpolation::Linear);
    rest.command = motion::StraightMove{arc->target, arc->rates};
    return rest;
  }
  motion::ArcMove left = *arc;
  const arm::JointVector halfway = motion.at(halfOfTheRest(motion, time)).position;
  left.via.translation() = (arm::forwardKinematics(arm, halfway) * point.moved_frame).translation();
  rest.command = left;
  return rest;
}

}  // namespace cobot_command::path
