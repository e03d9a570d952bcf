// Planned paths as RViz shows them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paths/path_board.h"
#include <ros/time.h>
#include <visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>

#include "cobot_command/arm/types.h"

namespace cobot_command::ros_adapter {

/// When, and in which tf frame the robot base is.
struct MarkerSite {
  std::string base_frame;
  ros::Time stamp;
};

/// A line through the points of the tool; with fewer than two of them it takes the last line away.
[[nodiscard]] visualization_msgs::Marker toLine(const std::vector<arm::Pose>& tool_path,
                                                const MarkerSite& site);
/// In its place the ways of all these paths.
[[nodiscard]] visualization_msgs::Marker toLine(const std::vector<PathBoard::Shown>& paths,
                                                const MarkerSite& site);
/// Their points, corners with the spheres that the robot cuts them in, and what was refused; the markers that
/// were there before are taken away.
[[nodiscard]] visualization_msgs::MarkerArray toPoints(const std::vector<PathBoard::Shown>& paths,
                                                       const MarkerSite& site);
/// Nothing: takes it away.
[[nodiscard]] visualization_msgs::Marker toActivePoint(const std::optional<Eigen::Vector3d>& place,
                                                       const MarkerSite& site);

}  // namespace cobot_command::ros_adapter
