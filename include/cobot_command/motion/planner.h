// From a command to a trajectory: planned wholly before the start, or refused by name with the first
// offending point.
//
// The same code answers a check in the command layer and moves the simulated arm.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// Plans `command` from the posture `start` [rad].
///
/// PTP: synchronised trapezoids in joint space; the slowest joint runs at speed_ratio x speed_override of its
/// rated speed and reaches it in time_to_top_speed (short moves stay triangular, with the same acceleration).
/// Line, Circle: a trapezoid along the path; every sample (at most 1 ms apart) must be reachable with the
/// pose bits of the start, inside the joint limits and the rated joint speeds, and away from the
/// singularities.
/// MovePtp, MoveLine, MovePLine: the same, to where the offset leads from `start`.
/// PLine: as a Line; to joints it must end in the very posture that they name.
/// Pvt: cubics between the points, of the joints or of the TCP, all times 1 / speed_override as long; joints
/// inside their limits and rated speeds everywhere, a TCP path as any other.
[[nodiscard]] Result<TrajectoryPtr, Refusal> plan(const arm::ArmModel& arm, const arm::JointVector& start,
                                                  const Command& command, const Setting& setting);

}  // namespace cobot_command::motion
