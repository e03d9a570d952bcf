// Motion without a target: the arm takes a velocity and keeps it until the next one is set or its time ends.
#pragma once

#include <optional>
#include <variant>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

struct SetVelocity {
  /// Of each joint [rad/s], or of the TCP.
  std::variant<arm::JointVector, TcpVelocity> velocity;
  Duration ramp{};  ///< from the previous velocity to this one, and from this one to rest; above 0
  std::optional<Duration> lasting;  ///< from now until deceleration, at least `ramp`; absent: kMaxLasting
};

/// Longest duration of a velocity, and the default. An operator sets another velocity much earlier.
inline constexpr Duration kMaxLasting = std::chrono::minutes(10);

struct VelocityMotion {
  TrajectoryPtr trajectory;  ///< to rest; starts with the current velocity of the arm
  /// Why the arm stops earlier than requested.
  std::optional<Refusal> ends_at;
};

/// The velocity changes linearly during `ramp`, and linearly to rest at the end. The requested velocity is
/// multiplied by speed_override. If the arm cannot continue, it stops before that point. Refused if the
/// velocity is not possible even for `ramp`.
[[nodiscard]] Result<VelocityMotion, Refusal> planVelocity(const arm::ArmModel& arm, const JointState& now,
                                                           const SetVelocity& set, const Setting& setting);

}  // namespace cobot_command::motion
