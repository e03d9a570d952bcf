// What the command layer tells everyone: joint_states, tool_pose, robot_status, command_status, frames and
// tf.
//
// Called on the core's thread only.
#pragma once

#include <string>

#include <ros/publisher.h>
#include <tf2_ros/transform_broadcaster.h>

#include "cobot_command/blocks/command_core.h"
#include "cobot_command/ros/conversions.h"

namespace cobot_command::ros_adapter {

class StatusPublisher {
 public:
  /// Topics are relative to `node`. `prefix` stands in front of every tf frame; the joint names have it
  /// already.
  StatusPublisher(ros::NodeHandle node, JointNames joint_names, std::string prefix);

  /// Positions, tool and robot status, and in tf the active base and the active tool. Each only as far as the
  /// controller streams it.
  void publish(const link::RobotStatus& status);
  /// Latched; when the status stream has ended, robot_status becomes "unknown" as well.
  void publish(const blocks::CommandStatus& status, const ClockPair& clocks);
  /// Costs nothing while nobody listens.
  void publish(const blocks::FrameTraced& trace, const ClockPair& clocks);

 private:
  void publishFrames(const link::RobotStatus& status, const ros::Time& stamp);

  JointNames joint_names_;
  std::string prefix_;
  ros::Publisher joint_states_;
  ros::Publisher tool_pose_;
  ros::Publisher robot_status_;
  ros::Publisher command_status_;
  ros::Publisher frames_;
  tf2_ros::TransformBroadcaster tf_;
  bool streaming_ = false;
};

}  // namespace cobot_command::ros_adapter
