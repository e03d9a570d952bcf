#include "cobot_command/ros/command/status_publisher.h"

#include <utility>
#include <vector>

#include "command/status_messages.h"
#include "shared/robot_status_message.h"
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>

namespace cobot_command::ros_adapter {
namespace {

// Deep enough that a subscriber that is late for a moment loses nothing at 66 messages a second.
constexpr std::uint32_t kQueueSize = 100;
constexpr double kFreshEnough = 0.1;  // [s], for whoever begins to listen

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

StatusPublisher::StatusPublisher(ros::NodeHandle node, JointNames joint_names, std::string prefix)
    : joint_names_(std::move(joint_names)), prefix_(std::move(prefix)), base_frame_(prefix_ + "base") {
  joint_states_ = node.advertise<sensor_msgs::JointState>("joint_states", kQueueSize);
  tool_pose_ = node.advertise<geometry_msgs::PoseStamped>("tool_pose", kQueueSize);
  robot_status_ = node.advertise<cobot_command::RobotStatus>("robot_status", kQueueSize, true);
  command_status_ = node.advertise<cobot_command::CommandStatus>("command_status", kQueueSize, true);
  active_frames_topic_ = node.advertise<cobot_command::ActiveFrames>("active_frames", kQueueSize, true);
  planned_path_ = node.advertise<visualization_msgs::Marker>("planned_path", kQueueSize, true);
  frames_ = node.advertise<cobot_command::FrameTrace>("frames", kQueueSize);
  status_frames_ = node.advertise<cobot_command::FrameTrace>("status_frames", kQueueSize);
  publish(active_frames_);  // so that it can be read before anything is known
}

void StatusPublisher::publish(const link::RobotStatus& status) {
  const ros::Time stamp = ros::Time::now();
  if (status.joints && joint_states_.getNumSubscribers() > 0) {
    joint_states_.publish(jointState(joint_names_, *status.joints, pointerTo(status.joint_velocities),
                                     pointerTo(status.joint_torques), stamp));
  }
  if (status.tool && tool_pose_.getNumSubscribers() > 0) {
    geometry_msgs::PoseStamped message;
    message.header.stamp = stamp;
    message.header.frame_id = base_frame_;
    message.pose = toPoseMessage(*status.tool);
    tool_pose_.publish(message);
  }
  publishRobotStatus(toMessage(status, stamp));
  sendActiveFrames(stamp);
}

/// A latched message costs as much as one that is listened to: without a listener it is only kept fresh.
void StatusPublisher::publishRobotStatus(cobot_command::RobotStatus message) {
  const ros::Time stamp = message.header.stamp;
  message.header.stamp = robot_status_told_.header.stamp;
  const bool is_news = message != robot_status_told_ || stamp < message.header.stamp ||
                       stamp - message.header.stamp >= ros::Duration(kFreshEnough);
  if (!is_news && robot_status_.getNumSubscribers() == 0) return;
  message.header.stamp = stamp;
  robot_status_.publish(message);
  robot_status_told_ = std::move(message);
}

void StatusPublisher::publish(const robot::ActiveFrames& frames) {
  const ros::Time stamp = ros::Time::now();
  active_frames_ = frames;
  active_frames_topic_.publish(toMessage(frames, base_frame_, stamp));
  sendActiveFrames(stamp);
}

void StatusPublisher::publish(const command::PathPlanned& path) {
  planned_path_.publish(toMarker(path.tool_path, base_frame_, ros::Time::now()));
}

void StatusPublisher::sendActiveFrames(const ros::Time& stamp) {
  // tf warns of everything that comes with the stamp of what it has; a simulated clock may be slower than the
  // stream.
  if (stamp == frames_sent_) return;
  frames_sent_ = stamp;
  std::vector<geometry_msgs::TransformStamped> frames;
  if (active_frames_.base) {
    frames.push_back(stamped(*active_frames_.base, base_frame_, prefix_ + "active_base", stamp));
  }
  if (active_frames_.tcp) {
    frames.push_back(stamped(*active_frames_.tcp, prefix_ + "tool0", prefix_ + "active_tool", stamp));
  }
  if (!frames.empty()) tf_.sendTransform(frames);
}

void StatusPublisher::publish(const command::CommandStatus& status, const ClockPair& clocks) {
  command_status_.publish(toMessage(status, clocks));
  if (streaming_ && !status.status_stream) {
    publishRobotStatus(toMessage(link::RobotStatus{}, clocks.ros_now));
  }
  streaming_ = status.status_stream;
}

void StatusPublisher::publish(const command::FrameTraced& trace, const ClockPair& clocks) {
  if (isHeard(trace.channel)) topicOf(trace.channel).publish(toMessage(trace, clocks));
}

bool StatusPublisher::isHeard(link::Channel channel) const {
  return topicOf(channel).getNumSubscribers() > 0;
}

const ros::Publisher& StatusPublisher::topicOf(link::Channel channel) const {
  return channel == link::Channel::Script ? frames_ : status_frames_;
}

}  // namespace cobot_command::ros_adapter
