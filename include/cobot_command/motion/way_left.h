// What is left of a way that was planned, seen from a time on it.
#pragma once

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// When that share, 0..1, is done of the way that is left behind `time`; to a millisecond.
[[nodiscard]] Duration timeOfShareLeft(const Trajectory& motion, Duration time, double share);

/// An arc through these places [m] is so flat that it is not planned as one, and a line is as good: it leaves
/// its chord by less than a fifth of a millimetre.
[[nodiscard]] bool isNextToStraight(const Eigen::Vector3d& begin, const Eigen::Vector3d& middle,
                                    const Eigen::Vector3d& end);

}  // namespace cobot_command::motion
