// Point to point: a straight line in joint space.
#pragma once

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// Precondition: checkInput() found nothing.
[[nodiscard]] Result<TrajectoryPtr, Refusal> planPtp(const arm::ArmModel& arm, const arm::JointVector& start,
                                                     const Ptp& ptp, const Setting& setting);

}  // namespace cobot_command::motion
