// Half a turn can be made either way round. Which way a controller takes is not known, and a start that is a
// little different may change it: so a plan of it would be a guess.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::motion {

/// Refuses a turn [rad, 0..pi] of the TCP that setting.start_tolerance does not keep away from half a turn.
/// `to`: where it ends, in the robot base; `name`: "line", for the message.
[[nodiscard]] std::optional<Refusal> ambiguousTurn(double turn, const arm::Pose& to, const char* name,
                                                   const Setting& setting);

/// The same for a joint of a PTP to a pose: it could come to the pose as well by turning the other way, in
/// its limits. `point`: the target, in the active base.
[[nodiscard]] std::optional<Refusal> ambiguousPosture(const arm::ArmModel& arm, const arm::JointVector& start,
                                                      const arm::JointVector& target, const arm::Pose& point,
                                                      const Setting& setting);

}  // namespace cobot_command::motion
