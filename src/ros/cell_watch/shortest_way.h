// The shortest way between the two robots that are closest to each other, for people to see.
#pragma once

#include <optional>
#include <vector>

#include "cell_watch/cell_markers.h"
#include "cell_watch/watch.h"

#include "cobot_command/cell/bodies/robot_bodies.h"

namespace cobot_command::ros_adapter {

/// `bodies`: of the robots, in the order of the view, with what they may carry. Between the bodies of which
/// the monitor says that they are closest; nothing, while all are far, or not known.
[[nodiscard]] std::optional<ShortestWay> shortestWay(const std::vector<cell::RobotBodies>& bodies,
                                                     const WatchView& view);

}  // namespace cobot_command::ros_adapter
