// Checks a single segment of a joint PVT, with the same checks as a whole PVT.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// Tolerances beyond the joint limits and rated speeds, because the numbers of a PVT are rounded.
struct PvtRoom {
  double position = 1e-6;  ///< [rad]
  double speed = 1e-3;     ///< ratio of the rated speed
};

struct PvtOffence {
  Refusal::Reason reason = Refusal::Reason::JointLimit;  ///< or JointSpeed
  int joint = 0;
  double time = 0.0;        ///< since the start of the segment [s]
  double found = 0.0;       ///< [rad or rad/s]
  arm::JointVector joints;  ///< at that time [rad]
};

/// Checks the cubic from `from` to the point in closed form: where each joint reverses, and where it is
/// fastest. A joint outside its limits may return, but must not move further out.
[[nodiscard]] std::optional<PvtOffence> checkPvtSegment(const arm::ArmModel& arm, const JointState& from,
                                                        const PvtJointPoint& to, const PvtRoom& room = {});

}  // namespace cobot_command::motion
