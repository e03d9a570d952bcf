// A trajectory as a few points: for answers, plots and markers.
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

/// So many steps after each other, from zero to `last`; 0: zero alone.
[[nodiscard]] std::vector<Duration> evenTimes(Duration last, std::size_t steps);

/// `count` points (at least 2), evenly from the start to `until`, or to the end where that is earlier; one
/// where there is no time between them.
[[nodiscard]] std::vector<JointPoint> jointPath(const motion::Trajectory& trajectory, std::size_t count,
                                                Duration until = Duration::max());

/// The TCP in the robot base [m] at the same times. `tcp`: in the flange.
[[nodiscard]] std::vector<arm::Pose> toolPath(const arm::ArmModel& arm, const motion::Trajectory& trajectory,
                                              const arm::Pose& tcp, std::size_t count,
                                              Duration until = Duration::max());

}  // namespace cobot_command::planning
