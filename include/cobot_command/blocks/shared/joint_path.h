// Planned motions as the points of a result, and the detail of a motion that was only checked.
#pragma once

#include <array>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::path {
class PathPlan;
}  // namespace cobot_command::path

namespace cobot_command::blocks {

struct JointPathPoint {
  Duration time{};                     ///< since the start of the motion
  std::array<double, 6> joints{};      ///< [rad]
  std::array<double, 6> velocities{};  ///< [rad/s]
};

[[nodiscard]] std::array<double, 6> toArray(const arm::JointVector& joints);

/// Detail of the outcome of a goal with check_only.
struct CheckedMotion {
  std::vector<JointPathPoint> joint_path;
};

/// Evenly spaced points from the start to `until`, or to the end if that is earlier: at least every 20 ms,
/// but at most 100 points.
[[nodiscard]] std::vector<JointPathPoint> jointPath(const motion::Trajectory& motion,
                                                    Duration until = Duration::max());

/// Points from the start to the end, both included: at least every 20 ms, but at most 5000 points.
[[nodiscard]] std::vector<JointPathPoint> wholeJointPath(const path::PathPlan& plan);

/// Consecutive motions, each as above; time since the start of the first one.
[[nodiscard]] std::vector<JointPathPoint> jointPath(const std::vector<motion::TrajectoryPtr>& motions);

}  // namespace cobot_command::blocks
