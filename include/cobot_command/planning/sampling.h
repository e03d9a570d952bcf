// Samples a trajectory at a few points, for answers, plots and markers.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::planning {

struct JointPoint {
  Duration time{};            ///< since the start of the trajectory
  arm::JointVector position;  ///< [rad]
  arm::JointVector velocity;  ///< [rad/s]
};

/// Times from zero to `last` in this number of equal steps; 0: only zero.
[[nodiscard]] std::vector<Duration> evenTimes(Duration last, std::size_t steps);

/// `count` points (at least 2) at equal intervals from the start to `until`, or to the end if that is
/// earlier. One point if the interval is empty.
[[nodiscard]] std::vector<JointPoint> jointPath(const motion::Trajectory& trajectory, std::size_t count,
                                                Duration until = Duration::max());

/// The TCP poses in the robot base [m] at the same times. `tcp`: in the flange.
[[nodiscard]] std::vector<arm::Pose> toolPath(const arm::ArmModel& arm, const motion::Trajectory& trajectory,
                                              const arm::Pose& tcp, std::size_t count,
                                              Duration until = Duration::max());

}  // namespace cobot_command::planning
