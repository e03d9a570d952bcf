#include "cobot_command/planning/sampling.h"

#include <algorithm>

#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::planning {

std::vector<Duration> evenTimes(Duration last, std::size_t steps) {
  const auto count = static_cast<Duration::rep>(steps);
  std::vector<Duration> times{Duration::zero()};
  times.reserve(steps + 1);
  for (Duration::rep i = 1; i <= count; ++i) {
    // Whole steps first: hours in nanoseconds times the count could overflow.
    times.push_back(last / count * i + last % count * i / count);
  }
  return times;
}

std::vector<JointPoint> jointPath(const motion::Trajectory& trajectory, std::size_t count, Duration until) {
  const Duration last = std::clamp(until, Duration::zero(), trajectory.duration());
  const std::size_t steps = last == Duration::zero() ? 0 : std::max<std::size_t>(count, 2) - 1;
  std::vector<JointPoint> points;
  points.reserve(steps + 1);
  for (const Duration time : evenTimes(last, steps)) {
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
