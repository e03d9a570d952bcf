// From a motion line of a script (mm, degrees, ms, %) to a command of motion/ (SI).
#pragma once

#include <variant>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::simulator {

using MotionRequest =
    std::variant<protocol::Ptp, protocol::Line, protocol::Circle, protocol::MovePtp, protocol::MoveLine>;

/// `start`: the posture where the motion begins; relative motions count from there. Refused when the pose
/// bits are not 0..1, 2..3, 4..5; all other checks are motion::plan's.
///
/// A relative pose in the base: the TCP is shifted along the base axes and turned about axes parallel to them
/// (R = R(offset) R(start), as the manual's trans() measures it). In the tool: start * offset.
[[nodiscard]] Result<motion::Command, motion::Refusal> toCommand(const MotionRequest& request,
                                                                 const arm::ArmModel& arm,
                                                                 const arm::JointVector& start,
                                                                 const motion::Setting& setting);

}  // namespace cobot_command::simulator
