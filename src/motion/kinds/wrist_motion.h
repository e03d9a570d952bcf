// The TCP's place on a straight line, the wrist joints in step with it.
#pragma once

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// Precondition: checkInput() found nothing.
[[nodiscard]] Result<TrajectoryPtr, Refusal> planWristMove(const arm::ArmModel& arm,
                                                           const arm::JointVector& start,
                                                           const WristMove& move, const Setting& setting);

}  // namespace cobot_command::motion
