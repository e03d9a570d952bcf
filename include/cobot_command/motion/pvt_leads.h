// Represents a move with its own ramps by a PVT whose cubics are nowhere steeper than the move.
#pragma once

#include <vector>

#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// The time by which the move must be ahead of its plan at each of these times since its start, with the
/// speed of the plan [s]; negative: behind the plan. The acceleration of a cubic is linear in time, so a
/// cubic with the positions and speeds of the move at both ends exceeds the move's acceleration where that
/// curve bends: by up to 28 % next to the corner of a ramp.
///
/// `times` must increase. The first is not after the start of the move and the last not before its end; at
/// both the lead is zero. The lead is also zero all along the cruise if both ends of the cruise are among the
/// times. A ramp whose ends are among the times is at most 0.5 % steeper than planned; any other ramp as
/// little as possible without large deviations from its plan. A command without its own ramps has no lead.
[[nodiscard]] std::vector<double> leadsAt(const Command& command, const Trajectory& move,
                                          const std::vector<Duration>& times);

}  // namespace cobot_command::motion
