#include "cobot_command/path/path_rest.h"

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/motion/way_left.h"

namespace cobot_command::path {
PlannedPoint restOf(const PlannedPoint& point, Duration time, const arm::ArmModel& arm) {
  PlannedPoint rest = point;
  const auto* const arc = std::get_if<motion::ArcMove>(&point.command);
  if (arc == nullptr || time <= Duration::zero()) return rest;
  const motion::Trajectory& motion = *point.motion;
  const auto tcp_at = [&](Duration at) -> Eigen::Vector3d {
    return (arm::forwardKinematics(arm, motion.at(at).position) * point.moved_frame).translation();
  };
  const Eigen::Vector3d halfway = tcp_at(motion::timeOfShareLeft(motion, time, 0.5));
  if (motion::isNextToStraight(tcp_at(time), halfway, tcp_at(motion.duration()))) {
    rest.point.interpolation = static_cast<int>(Interpolation::Linear);
    rest.command = motion::StraightMove{arc->target, arc->rates};
    return rest;
  }
  motion::ArcMove left = *arc;
  left.via.translation() = halfway;
  rest.command = left;
  return rest;
}

}  // namespace cobot_command::path
