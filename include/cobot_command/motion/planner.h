// Plans a command into a trajectory, completely before the start, or refuses it with the first offending
// point.
//
// The same code performs the checks of the command layer and moves the simulated arm.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// Plans `command` from the posture `start` [rad].
///
/// PTP: synchronised trapezoids in joint space. The slowest joint runs at speed_ratio x speed_override of its
/// rated speed and reaches it in time_to_top_speed (short moves are triangular, with the same acceleration).
/// Line, Circle: a trapezoid along the path. Every sample (at most 1 ms apart) must be reachable with the
/// pose bits of the start, within the joint limits and the rated joint speeds, and away from the
/// singularities. MovePtp, MoveLine, MovePLine: the same, to the target that the offset gives from `start`.
/// PLine: as a Line; a PLine to joints must end in exactly the given posture. Pvt: cubics between the points,
/// of the joints or of the TCP, with all times multiplied by 1 / speed_override. The joints must be within
/// their limits and rated speeds everywhere; a TCP path is checked as any other.
[[nodiscard]] Result<TrajectoryPtr, Refusal> plan(const arm::ArmModel& arm, const arm::JointVector& start,
                                                  const Command& command, const Setting& setting);

}  // namespace cobot_command::motion
