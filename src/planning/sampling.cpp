#include "cobot_command/planning/sampling.h"

#include <algorithm>

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::planning {

std::vector<JointPoint> jointPath(const motion::Trajectory& trajectory, std::size_t count, Duration until) {
  const Duration last = std::clamp(until, Duration::zero(), trajectory.duration());
  const auto steps =
      last == Duration::zero() ? 0 : static_cast<Duration::rep>(std::max<std::size_t>(count, 2) - 1);
  std::vector<JointPoint> points;
  points.reserve(static_cast<std::size_t>(steps) + 1);
  for (Duration::rep i = 0; i <= steps; ++i) {
    // Whole steps first: hours in nanoseconds times the count could overflow.
    const Duration time = steps == 0 ? Duration::zero() : last / steps * i + last % steps * i / steps;
    const motion::JointState state = trajectory.at(time);
    points.push_back({time, state.position, state.velocity});
  }
  return points;
}

std::vector<arm::Pose> toolPath(const arm::ArmModel& arm, const motion::Trajectory& trajectory,
                                const arm::Pose& tcp, std::size_t count, Duration until) {
  const std::vector<JointPoint> joints = jointPath(trajectory, count, until);
  std::vector<arm::Pose> poses(joints.size());
  std::transform(joints.begin(), joints.end(), poses.begin(), [&](const JointPoint& point) -> arm::Pose {
    return arm::forwardKinematics(arm, point.position) * tcp;
  });
  return poses;
}

}  // namespace cobot_command::planning
