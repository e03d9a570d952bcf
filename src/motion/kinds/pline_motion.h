// Lines that are passed one after the other at one speed.
#pragma once

#include <optional>

#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

/// From rest to rest. Precondition: checkInput() found nothing.
[[nodiscard]] Result<TrajectoryPtr, Refusal> planPLine(const arm::ArmModel& arm,
                                                       const arm::JointVector& start, const PLine& line,
                                                       const Setting& setting);

/// How `next` takes over from `before` without losing speed; nothing where they are not both PLines, are
/// planned with different TCPs, or where the arm cannot do so.
[[nodiscard]] std::optional<Passage> passOn(const arm::ArmModel& arm, const Trajectory& before,
                                            const Trajectory& next, BlendShare share, Duration left);

}  // namespace cobot_command::motion
