// Moves with rates and ramps of their own: in joint space, straight and along an arc.
#pragma once

#include "paths/path_check.h"
#include "profiles/ramped_profile.h"

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// Precondition of all: checkInput() found nothing.
[[nodiscard]] Result<TrajectoryPtr, Refusal> planJointMove(const arm::ArmModel& arm,
                                                           const arm::JointVector& start,
                                                           const JointMove& move, const Setting& setting);
[[nodiscard]] Result<TrajectoryPtr, Refusal> planStraightMove(const arm::ArmModel& arm,
                                                              const arm::JointVector& start,
                                                              const StraightMove& move,
                                                              const Setting& setting);
[[nodiscard]] Result<TrajectoryPtr, Refusal> planArcMove(const arm::ArmModel& arm,
                                                         const arm::JointVector& start, const ArcMove& move,
                                                         const Setting& setting);

/// The profile of a way of `length` [m] with a turn of `turn` [rad] in step with it, at `speed_override`;
/// none of both: no time.
[[nodiscard]] ProfilePtr profileOf(double length, double turn, const PathRates& rates, double speed_override);

/// For messages: the one of both speeds that rules; not above the one that is reached in `travel` [s], the
/// time of the whole way at top speed.
[[nodiscard]] AskedSpeed askedSpeed(double length, double turn, const PathRates& rates, double travel);

}  // namespace cobot_command::motion
