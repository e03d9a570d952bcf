// Motion without a target: the arm takes a velocity and keeps it, until the next one or until nobody asks for
// it any more.
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
  /// Of each joint [rad/s]; or of the TCP.
  std::variant<arm::JointVector, TcpVelocity> velocity;
  Duration ramp{};  ///< from the velocity before to this one, and from this one to rest; above 0
  std::optional<Duration>
      lasting;  ///< from now until it slows down, at least `ramp`; absent: see kMaxLasting
};

/// A velocity that is set for no time lasts as long as this: nobody can steer for so long without another
/// one.
inline constexpr Duration kMaxLasting = std::chrono::minutes(10);

struct VelocityMotion {
  TrajectoryPtr trajectory;  ///< to rest; begins with the velocity that the arm has
  /// Why it comes to rest sooner than it was asked to: what is in its way.
  std::optional<Refusal> ends_at;
};

/// The velocity grows, or falls, evenly in `ramp`, and evenly to rest at the end; with speed_override times
/// what is asked for. Where the arm cannot go on it is at rest before. Refused: what cannot be done even for
/// `ramp`.
[[nodiscard]] Result<VelocityMotion, Refusal> planVelocity(const arm::ArmModel& arm, const JointState& now,
                                                           const SetVelocity& set, const Setting& setting);

}  // namespace cobot_command::motion
