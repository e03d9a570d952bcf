// Conversions between values of the core and parts of messages: times, poses, joints. Units change only if a
// message's comment states it. Whole messages: src/ros/actions, status_messages.h and others of that name.
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

/// Converts the core's instants into ROS time. The clocks differ, so both present times are stored.
struct ClockPair {
  ros::Time ros_now;
  Instant core_now;
  [[nodiscard]] ros::Time toRos(Instant instant) const;
};

[[nodiscard]] ros::Duration toRos(Duration duration);
/// nullopt: zero.
[[nodiscard]] ros::Duration toRos(const std::optional<Duration>& duration);

[[nodiscard]] std::array<double, 6> toSix(const cobot_command::Transformation& message);
[[nodiscard]] cobot_command::Transformation toTransformation(const std::array<double, 6>& six);

[[nodiscard]] geometry_msgs::Transform toTransform(const arm::Pose& pose);
[[nodiscard]] geometry_msgs::Pose toPoseMessage(const arm::Pose& pose);
[[nodiscard]] arm::Pose toPose(const geometry_msgs::Transform& message);
/// A quaternion of length zero, as in a new message, means no rotation.
[[nodiscard]] arm::Pose toPose(const geometry_msgs::Pose& message);

using JointNames = std::array<std::string, arm::kJointCount>;
/// The six joints with the names of the vendor's driver, after `prefix`.
[[nodiscard]] JointNames jointNames(const std::string& prefix);
/// Positions [rad], velocities [rad/s] and torques [Nm]; missing values stay empty.
[[nodiscard]] sensor_msgs::JointState jointState(const JointNames& names, const arm::JointVector& positions,
                                                 const arm::JointVector* velocities,
                                                 const arm::JointVector* torques, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
