// The frames of tf, seen from the base of one robot.
#pragma once

#include <string>

#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "cobot_command/ros/goal_messages.h"

namespace cobot_command::ros_adapter {

/// Listens to tf on a thread of its own, as tf2 does.
class TfFrames {
 public:
  explicit TfFrames(std::string robot_base) : robot_base_(std::move(robot_base)), listener_(buffer_) {}

  /// As a FrameLookup does.
  [[nodiscard]] FramePlace find(const std_msgs::Header& header) const;

 private:
  std::string robot_base_;
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
};

}  // namespace cobot_command::ros_adapter
