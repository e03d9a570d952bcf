// Values of the core <-> messages. Units change only where a message's comment says so.
#pragma once

#include <array>
#include <string>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <ros/time.h>
#include <sensor_msgs/JointState.h>

#include "cobot_command/BlockStatus.h"
#include "cobot_command/CommandStatus.h"
#include "cobot_command/ConnectFeedback.h"
#include "cobot_command/ConnectGoal.h"
#include "cobot_command/ConnectResult.h"
#include "cobot_command/FrameTrace.h"
#include "cobot_command/MoveAbsoluteFeedback.h"
#include "cobot_command/MoveAbsoluteGoal.h"
#include "cobot_command/MoveAbsoluteResult.h"
#include "cobot_command/RobotStatus.h"
#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/command_core.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] blocks::Goal toGoal(const cobot_command::ConnectGoal& message);
[[nodiscard]] blocks::Goal toGoal(const cobot_command::MoveAbsoluteGoal& message);

void fill(cobot_command::ConnectResult& message, const blocks::Outcome& outcome);
void fill(cobot_command::MoveAbsoluteResult& message, const blocks::Outcome& outcome);
void fill(cobot_command::ConnectFeedback& message, const blocks::Progress& progress);
void fill(cobot_command::MoveAbsoluteFeedback& message, const blocks::Progress& progress);

/// Turns the core's instants into ROS time. They have different clocks, so both are asked for now.
struct ClockPair {
  ros::Time ros_now;
  Instant core_now;
  [[nodiscard]] ros::Time toRos(Instant instant) const;
};

[[nodiscard]] cobot_command::CommandStatus toMessage(const blocks::CommandStatus& status,
                                                     const ClockPair& clocks);
[[nodiscard]] cobot_command::FrameTrace toMessage(const blocks::FrameTraced& trace, const ClockPair& clocks);
[[nodiscard]] cobot_command::RobotStatus toMessage(const link::RobotStatus& status, const ros::Time& stamp);

using JointNames = std::array<std::string, arm::kJointCount>;
/// The six joints as the vendor's driver names them, with `prefix` in front.
[[nodiscard]] JointNames jointNames(const std::string& prefix);
/// Positions [rad], velocities [rad/s] and torques [Nm]; what is absent stays empty.
[[nodiscard]] sensor_msgs::JointState jointState(const JointNames& names, const arm::JointVector& positions,
                                                 const arm::JointVector* velocities,
                                                 const arm::JointVector* torques, const ros::Time& stamp);

[[nodiscard]] geometry_msgs::Transform toTransform(const arm::Pose& pose);
[[nodiscard]] geometry_msgs::Pose toPoseMessage(const arm::Pose& pose);

}  // namespace cobot_command::ros_adapter
