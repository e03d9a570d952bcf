// The frames of tf, seen from the base of one robot.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <ros/time.h>
#include <std_msgs/Header.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/command/goal_lookups.h"

namespace cobot_command::ros_adapter {

/// Listens to tf on a thread of its own, as tf2 does. Its functions are for one thread, but for whereNow().
///
/// /tf is one topic for everybody: where N robots listen to it, each gets the frames of all, N times N
/// messages. Those that use no frames but their own need not listen.
class TfFrames {
 public:
  /// `from_start`: listen at once; else from the first find() on, which then knows nothing of earlier times.
  TfFrames(std::string robot_base, bool from_start);

  /// As a FrameLookup does.
  [[nodiscard]] FramePlace find(const std_msgs::Header& header);
  /// As a FrameFinder does, from any thread: tf2's buffer has a lock of its own. Knows nothing before find().
  [[nodiscard]] std::optional<arm::Pose> whereNow(const std::string& frame) const;
  /// How long a frame that is not known is worth waiting for.
  [[nodiscard]] Duration patience() const;

 private:
  void listen();

  std::string robot_base_;
  tf2_ros::Buffer buffer_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;  // after the buffer that it fills
  ros::SteadyTime listening_since_;
};

}  // namespace cobot_command::ros_adapter
