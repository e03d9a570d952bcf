// One segment of a PVT of the joints by itself, checked as the whole is.
#pragma once

#include <optional>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// How far a joint may be beyond what is allowed, as what is said in a PVT is rounded.
struct PvtRoom {
  double position = 1e-6;  ///< [rad]
  double speed = 1e-3;     ///< share of the rated speed
};

struct PvtOffence {
  Refusal::Reason reason = Refusal::Reason::JointLimit;  ///< or JointSpeed
  int joint = 0;
  double time = 0.0;        ///< since the segment began [s]
  double found = 0.0;       ///< [rad or rad/s]
  arm::JointVector joints;  ///< there [rad]
};

/// The cubic from `from` to the point, in closed form: where each joint turns round, and where it is fastest.
/// A joint that is outside its limits may come back, and go no further out.
[[nodiscard]] std::optional<PvtOffence> checkPvtSegment(const arm::ArmModel& arm, const JointState& from,
                                                        const PvtJointPoint& to, const PvtRoom& room = {});

}  // namespace cobot_command::motion
