#include "cobot_command/ros/command/status_publisher.h"

#include <utility>
#include <vector>

#include "command/status_messages.h"
#include "shared/robot_status_message.h"
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

namespace cobot_command::ros_adapter {
namespace {

// Deep enough that a subscriber that is late for a moment loses nothing at 66 messages a second.
constexpr std::uint32_t kQueueSize = 100;
constexpr double kFreshEnough = 0.5;  // [s], for whoever begins to listen, until the next frame

const arm::JointVector* pointerTo(const std::optional<arm::JointVector>& value) {
  return value ? &*value : nullptr;
}

geometry_msgs::TransformStamped stamped(const arm::Pose& pose, const std::string& parent,
                                        const std::string& child, const ros::Time& stamp) {
  geometry_msgs::TransformStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform = toTransform(pose);
  return message;
}

}  // namespace

StatusPublisher::StatusPublisher(OwnHandle node, JointNames joint_names, std::string prefix)
    : joint_names_(std::move(joint_names)), prefix_(std::move(prefix)), base_frame_(prefix_ + "base") {
  joint_states_ = HeardTopic::advertise<sensor_msgs::JointState>(node, "joint_states", kQueueSize);
  tool_pose_ = HeardTopic::advertise<geometry_msgs::PoseStamped>(node, "tool_pose", kQueueSize);
  robot_status_ = HeardTopic::advertise<cobot_command::RobotStatus>(node, "robot_status", kQueueSize, true);
  command_status_ = node.advertise<cobot_command::CommandStatus>("command_status", kQueueSize, true);
  active_frames_topic_ = node.advertise<cobot_command::ActiveFrames>("active_frames", kQueueSize, true);
  frames_ = HeardTopic::advertise<cobot_command::FrameTrace>(node, "frames", kQueueSize);
  status_frames_ = HeardTopic::advertise<cobot_command::FrameTrace>(node, "status_frames", kQueueSize);
  tf_ = HeardTopic::advertise<tf2_msgs::TFMessage>(node, "/tf", kQueueSize);
  group_state_ = node.advertise<cobot_command::GroupState>("group_state", kQueueSize, true);
  digital_io_ = node.advertise<cobot_command::DigitalIo>("digital_io", kQueueSize, true);
  // So that they can be read before anything is known.
  publish(command::GroupState());
  publish(active_frames_);
  digital_io_.publish(toMessage(inputs_told_, outputs_told_, ros::Time::now()));
}

void StatusPublisher::publish(const command::GroupState& state) {
  group_state_.publish(toMessage(state, ros::Time::now()));
}

void StatusPublisher::publish(const command::RobotStatusReceived& received) {
  const link::RobotStatus& status = received.status;
  const ros::Time stamp = ros::Time::now();
  if (status.joints && joint_states_.isHeard()) {
    joint_states_.publish(jointState(joint_names_, *status.joints, pointerTo(status.joint_velocities),
                                     pointerTo(status.joint_torques), stamp));
  }
  if (status.tool && tool_pose_.isHeard()) {
    geometry_msgs::PoseStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = base_frame_;
    message.pose = toPoseMessage(*status.tool);
    tool_pose_.publish(message);
  }
  publishRobotStatus(toMessage(status, received.moving, stamp));
  publishDigitalIo(status, stamp);
  sendActiveFrames(stamp);
}

/// A latched message costs as much as one that is listened to: without a listener it is only kept fresh.
void StatusPublisher::publishRobotStatus(cobot_command::RobotStatus message) {
  const ros::Time stamp = message.header.stamp;
  message.header.stamp = robot_status_told_.header.stamp;
  const bool is_news = message != robot_status_told_ || stamp < message.header.stamp ||
                       stamp - message.header.stamp >= ros::Duration(kFreshEnough);
  if (!is_news && !robot_status_.isHeard()) return;
  message.header.stamp = stamp;
  robot_status_.publish(message);
  robot_status_told_ = std::move(message);
}

void StatusPublisher::publishDigitalIo(const link::RobotStatus& status, const ros::Time& stamp) {
  if (status.inputs == inputs_told_ && status.outputs == outputs_told_) return;
  inputs_told_ = status.inputs;
  outputs_told_ = status.outputs;
  digital_io_.publish(toMessage(inputs_told_, outputs_told_, stamp));
}

void StatusPublisher::publish(const robot::ActiveFrames& frames) {
  const ros::Time stamp = ros::Time::now();
  active_frames_ = frames;
  active_frames_topic_.publish(toMessage(frames, base_frame_, stamp));
  sendActiveFrames(stamp);
}

void StatusPublisher::sendActiveFrames(const ros::Time& stamp) {
  // tf warns of everything that comes with the stamp of what it has; a simulated clock may be slower than the
  // stream.
  if (!tf_.isHeard() || stamp == frames_sent_) return;
  frames_sent_ = stamp;
  tf2_msgs::TFMessage message;
  if (active_frames_.base) {
    message.transforms.push_back(stamped(*active_frames_.base, base_frame_, prefix_ + "active_base", stamp));
  }
  if (active_frames_.tcp) {
    message.transforms.push_back(
        stamped(*active_frames_.tcp, prefix_ + "tool0", prefix_ + "active_tool", stamp));
  }
  if (!message.transforms.empty()) tf_.publish(message);
}

void StatusPublisher::publish(const command::CommandStatus& status, const ClockPair& clocks) {
  command_status_.publish(toMessage(status, clocks));
  if (streaming_ && !status.status_stream) {
    publishRobotStatus(toMessage(link::RobotStatus{}, std::nullopt, clocks.ros_now));
    publishDigitalIo(link::RobotStatus{}, clocks.ros_now);
  }
  streaming_ = status.status_stream;
}

void StatusPublisher::publish(const command::FrameTraced& trace, const ClockPair& clocks) {
  if (isHeard(trace.channel)) topicOf(trace.channel).publish(toMessage(trace, clocks));
}

bool StatusPublisher::isHeard(link::Channel channel) const {
  return topicOf(channel).isHeard();
}

const HeardTopic& StatusPublisher::topicOf(link::Channel channel) const {
  return channel == link::Channel::Script ? frames_ : status_frames_;
}

}  // namespace cobot_command::ros_adapter
