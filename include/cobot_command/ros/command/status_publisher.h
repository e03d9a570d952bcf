// The published state of the command layer: joint_states, tool_pose, robot_status, digital_io,
// command_status, group_state, active_frames, frames, status_frames and tf.
//
// Called only on the core's thread.
#pragma once

#include <string>
#include <vector>

#include <ros/publisher.h>

#include "cobot_command/RobotStatus.h"
#include "cobot_command/command/command_core.h"
#include "cobot_command/ros/command/heard_topic.h"
#include "cobot_command/ros/shared/conversions.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

class StatusPublisher {
 public:
  /// Topics are relative to `node`. `prefix` precedes the name of every tf frame; the joint names already
  /// include it.
  StatusPublisher(OwnHandle node, JointNames joint_names, std::string prefix);

  /// Publishes positions, tool and robot status, as far as the controller streams them; its digital inputs
  /// and outputs if they have changed; and the active frames in tf again.
  void publish(const command::RobotStatusReceived& received);
  /// Latched. When the status stream has ended, robot_status and digital_io become "unknown" too.
  void publish(const command::CommandStatus& status, const ClockPair& clocks);
  /// Latched, and at once in tf, as far as they are known.
  void publish(const command::GroupState& state);
  void publish(const robot::ActiveFrames& frames);
  /// The frames of each port have a topic of their own, because the stream has many more frames than the
  /// commands.
  void publish(const command::FrameTraced& trace, const ClockPair& clocks);
  /// True: the topic of that port has a subscriber.
  [[nodiscard]] bool isHeard(link::Channel channel) const;

 private:
  [[nodiscard]] const HeardTopic& topicOf(link::Channel channel) const;
  void publishRobotStatus(cobot_command::RobotStatus message);
  void publishDigitalIo(const link::RobotStatus& status, const ros::Time& stamp);
  void sendActiveFrames(const ros::Time& stamp);

  JointNames joint_names_;
  std::string prefix_;
  std::string base_frame_;
  HeardTopic joint_states_;
  HeardTopic tool_pose_;
  HeardTopic robot_status_;
  ros::Publisher command_status_;
  ros::Publisher group_state_;
  ros::Publisher active_frames_topic_;
  ros::Publisher digital_io_;
  HeardTopic frames_;
  HeardTopic status_frames_;
  HeardTopic tf_;
  cobot_command::RobotStatus robot_status_told_;  ///< the last published one
  link::DigitalLevels inputs_told_;               ///< the last published ones
  link::DigitalLevels outputs_told_;
  robot::ActiveFrames active_frames_;
  ros::Time frames_sent_;  ///< stamp of the last active frames in tf
  bool streaming_ = false;
};

}  // namespace cobot_command::ros_adapter
