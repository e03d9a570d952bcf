// Points with their velocities and times: cubics between them.
#pragma once

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// A velocity behind the last point up to this counts as none [rad/s and m/s]: 0.06 deg/s, 1 mm/s.
inline constexpr double kPvtRest = 1e-3;

/// Precondition of all: checkInput() found nothing.
[[nodiscard]] Result<TrajectoryPtr, Refusal> planPvt(const arm::ArmModel& arm, const arm::JointVector& start,
                                                     const Pvt& pvt, const Setting& setting);
[[nodiscard]] Result<TrajectoryPtr, Refusal> planJointPvt(const arm::ArmModel& arm,
                                                          const arm::JointVector& start,
                                                          const std::vector<PvtJointPoint>& points,
                                                          const Setting& setting);

}  // namespace cobot_command::motion
