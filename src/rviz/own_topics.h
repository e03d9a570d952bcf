// What a panel shows in the scene is for its own RViz: topics of its node, so that two operators at one robot
// see their own target each, and take no drag of the other's.
#pragma once

#include <string>

#include <ros/names.h>
#include <ros/this_node.h>

namespace cobot_command::rviz_plugin {

inline constexpr const char* kPreviewJoints = "preview_joints";
inline constexpr const char* kPreviewMarkers = "preview";
inline constexpr const char* kDrivenPath = "driven_path";
inline constexpr const char* kPreviewTarget = "preview_target";

/// "preview" → "/rviz/preview".
[[nodiscard]] inline std::string ownTopic(const char* name) {
  return ros::names::append(ros::this_node::getName(), name);
}

}  // namespace cobot_command::rviz_plugin
