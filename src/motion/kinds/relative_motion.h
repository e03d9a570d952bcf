// A motion by an offset, as the motion to the place where the offset leads.
#pragma once

#include "cobot_command/motion/command.h"

namespace cobot_command::motion {

[[nodiscard]] Ptp absolute(const MovePtp& move, const arm::ArmModel& arm, const arm::JointVector& start,
                           const Setting& setting);
[[nodiscard]] Line absolute(const MoveLine& move, const arm::ArmModel& arm, const arm::JointVector& start,
                            const Setting& setting);
[[nodiscard]] PLine absolute(const MovePLine& move, const arm::ArmModel& arm, const arm::JointVector& start,
                             const Setting& setting);

}  // namespace cobot_command::motion
