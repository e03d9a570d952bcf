// What the monitor of a cell has seen, for pictures, messages and diagnostics.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/monitor/monitor_state.h"

namespace cobot_command::ros_adapter {

/// How things stand.
struct WatchView {
  /// A robot or a mechanism.
  struct Mover {
    std::string name;
    std::string space;  ///< of its command node, or of what moves the mechanism
    std::string topic;  ///< by which it is heard
    bool is_heard = false;
    bool takes_stops = false;  ///< somebody listens to them
    std::string carries;       ///< for people; empty: it never carries anything
  };
  cell::MonitorStatus status;
  std::vector<Mover> movers;             ///< robots, then mechanisms; both in the order of the cell
  std::vector<cell::SeenBodies> bodies;  ///< of these, and then of obstacles
};

}  // namespace cobot_command::ros_adapter
