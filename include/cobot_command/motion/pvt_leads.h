// How a move with ramps of its own is said by a PVT whose cubics are nowhere steeper than the move.
#pragma once

#include <vector>

#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// How far ahead of its plan the move has to be at each of these times since it began, with the speed of the
/// plan [s]; less than 0: behind it. The acceleration of a cubic grows evenly, so one that only has the
/// places and speeds of the move at both ends goes above it where that bends: by up to 28 % beside the corner
/// of a ramp.
///
/// `times` grow; the first one is not after the begin of the move, the last one not before its end, and at
/// both it is as planned. So it is all along its cruise, where both its ends are among them. A ramp that has
/// its ends among them is at most 0.5 % steeper than planned, any other as little as can be without getting
/// far from its plan. A command without ramps of its own is always as planned.
[[nodiscard]] std::vector<double> leadsAt(const Command& command, const Trajectory& move,
                                          const std::vector<Duration>& times);

}  // namespace cobot_command::motion
