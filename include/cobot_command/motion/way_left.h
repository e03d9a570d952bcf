// The remaining path of a planned motion at a given time.
#pragma once

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::motion {

/// The time at which this share, 0..1, of the path remaining after `time` is completed; to a millisecond.
[[nodiscard]] Duration timeOfShareLeft(const Trajectory& motion, Duration time, double share);

/// True if an arc through these positions [m] is too flat to be planned as an arc, and a line can replace it:
/// it deviates from its chord by less than a fifth of a millimetre.
[[nodiscard]] bool isNextToStraight(const Eigen::Vector3d& begin, const Eigen::Vector3d& middle,
                                    const Eigen::Vector3d& end);

}  // namespace cobot_command::motion
