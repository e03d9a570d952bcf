// What can be said about a request without the arm's geometry: finite, a proper pose, a possible speed.
#pragma once

#include <optional>

#include "cobot_command/motion/command.h"
#include "cobot_command/motion/refusal.h"

namespace cobot_command::motion {

/// Largest arc angle, either way [rad].
inline constexpr double kMaxArcAngle = 2.0 * 3.14159265358979323846;
/// No motion takes longer [s]. The slowest PTP of the family, J1 from end to end at 1 % and a project speed
/// of 5 %, takes 2.5 h.
inline constexpr double kMaxDuration = 3.0 * 3600.0;

/// The shortest time between two PVT points [s].
inline constexpr double kMinPvtDuration = 1e-3;

/// The first thing that is wrong with the request; nothing when it can be planned.
[[nodiscard]] std::optional<Refusal> checkInput(const arm::JointVector& start, const Command& command,
                                                const Setting& setting);

/// Refuses a joint target outside its limits.
[[nodiscard]] std::optional<Refusal> targetOutsideLimits(const arm::ArmModel& arm,
                                                         const arm::JointVector& target,
                                                         const Setting& setting);

/// Refuses a motion that would take longer than kMaxDuration.
[[nodiscard]] std::optional<Refusal> checkDuration(double seconds);

}  // namespace cobot_command::motion
