// Robots, mechanisms and obstacles of a cell as the monitor takes them: what RViz shows needs no description
// of any robot, nor its name.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <ros/time.h>
#include <visualization_msgs/MarkerArray.h>

#include "cobot_command/cell/monitor/monitor_state.h"

namespace cobot_command::ros_adapter {

/// The bodies of each where they were measured, and its name above them. The first `movers` are robots and
/// mechanisms, in the colours of their zones, but links paler than what is at the flange; the others are
/// grey and translucent.
[[nodiscard]] visualization_msgs::MarkerArray toBodyMarkers(const std::vector<cell::SeenBodies>& bodies,
                                                            std::size_t movers, const ros::Time& stamp);

/// Which markers there are: where these change, some have to be taken away.
[[nodiscard]] bool areSameMarkers(const visualization_msgs::MarkerArray& a,
                                  const visualization_msgs::MarkerArray& b);

}  // namespace cobot_command::ros_adapter
