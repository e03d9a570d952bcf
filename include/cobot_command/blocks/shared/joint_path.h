// Planned motions as the points of an answer.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::blocks {

/// Evenly from the start to `until`, or to the end where that is earlier: at least every 20 ms, but at most
/// 100 points.
[[nodiscard]] std::vector<JointPathPoint> jointPath(const motion::Trajectory& motion,
                                                    Duration until = Duration::max());

/// One behind the other, each as above; time since the start of the first.
[[nodiscard]] std::vector<JointPathPoint> jointPath(const std::vector<motion::TrajectoryPtr>& motions);

}  // namespace cobot_command::blocks
