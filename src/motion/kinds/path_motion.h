// Line and circle: the TCP on a path, the joints wherever that puts them.
#pragma once

#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// Precondition of both: checkInput() found nothing.
[[nodiscard]] Result<TrajectoryPtr, Refusal> planLine(const arm::ArmModel& arm, const arm::JointVector& start,
                                                      const Line& line, const Setting& setting);
[[nodiscard]] Result<TrajectoryPtr, Refusal> planCircle(const arm::ArmModel& arm,
                                                        const arm::JointVector& start, const Circle& circle,
                                                        const Setting& setting);

}  // namespace cobot_command::motion
