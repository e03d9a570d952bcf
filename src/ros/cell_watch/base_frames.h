// Where in the world the bases of the robots of a cell are, for tf.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <tf2_ros/static_transform_broadcaster.h>

#include "cobot_command/cell/program/cell.h"

namespace cobot_command::ros_adapter {

class BaseFrames {
 public:
  explicit BaseFrames(const cell::Cell& cell) : robots_(cell.robots) {}

  /// The base of that robot is the frame `base` behind this prefix. Where another robot has that frame it is
  /// not told, and a warning says so: tf would have one of them jump.
  void tell(std::size_t robot, const std::string& prefix);

 private:
  std::vector<cell::Robot> robots_;
  std::set<std::string> told_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
};

}  // namespace cobot_command::ros_adapter
