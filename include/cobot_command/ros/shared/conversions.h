// Values of the core <-> parts of messages: times, poses, joints. Units change only where a message's comment
// says so. Whole messages: src/ros/actions, status_messages.h and others of their name.
#pragma once

#include <array>
#include <optional>
#include <string>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/duration.h>
#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include "cobot_command/Transformation.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

/// Turns the core's instants into ROS time. They have different clocks, so both are asked for now.
struct ClockPair {
  ros::Time ros_now;
  Instant core_now;
  [[nodiscard]] ros::Time toRos(Instant instant) const;
};

[[nodiscard]] ros::Duration toRos(Duration duration);
/// Zero when absent.
[[nodiscard]] ros::Duration toRos(const std::optional<Duration>& duration);

[[nodiscard]] std::array<double, 6> toSix(const cobot_command::Transformation& message);
[[nodiscard]] cobot_command::Transformation toTransformation(const std::array<double, 6>& six);

[[nodiscard]] geometry_msgs::Transform toTransform(const arm::Pose& pose);
[[nodiscard]] geometry_msgs::Pose toPoseMessage(const arm::Pose& pose);
[[nodiscard]] arm::Pose toPose(const geometry_msgs::Transform& message);
/// A quaternion of length zero, as a new message has it, is no turn.
[[nodiscard]] arm::Pose toPose(const geometry_msgs::Pose& message);

using JointNames = std::array<std::string, arm::kJointCount>;
/// The six joints as the vendor's driver names them, with `prefix` in front.
[[nodiscard]] JointNames jointNames(const std::string& prefix);
/// Positions [rad], velocities [rad/s] and torques [Nm]; what is absent stays empty.
[[nodiscard]] sensor_msgs::JointState jointState(const JointNames& names, const arm::JointVector& positions,
                                                 const arm::JointVector* velocities,
                                                 const arm::JointVector* torques, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
