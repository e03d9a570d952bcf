// The shortest way between the two robots or mechanisms that are closest to each other, for people to see.
#pragma once

#include <optional>

#include "cell_watch/pictures/cell_markers.h"
#include "cell_watch/pictures/watch_view.h"

namespace cobot_command::ros_adapter {

/// Between the bodies of which the monitor says that they are closest; nothing, while all are far, or not
/// known.
[[nodiscard]] std::optional<ShortestWay> shortestWay(const WatchView& view);

}  // namespace cobot_command::ros_adapter
