// What can be wrong with how an arm follows a PVT: it goes straight between the points, or comes late.
//
// Made of a trajectory that was planned and checked; the end, and the rest there, stay as they are.
#pragma once

#include <vector>

#include "cobot_command/common/time.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::simulator {

/// Through where `path` is at these times since its start, rising; from one to the next, and from the last
/// one to the end, each joint runs evenly. It takes the same time.
[[nodiscard]] motion::TrajectoryPtr straightBetween(const motion::TrajectoryPtr& path,
                                                    const std::vector<Duration>& times);

/// So much behind `path`, and longer by as much. `lag` is not below zero, and `path` starts at rest.
[[nodiscard]] motion::TrajectoryPtr behind(const motion::TrajectoryPtr& path, Duration lag);

}  // namespace cobot_command::simulator
