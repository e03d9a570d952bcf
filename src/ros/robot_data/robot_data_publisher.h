// The latched topic robot_data. take() may be called from the core's thread.
#pragma once

#include <functional>
#include <memory>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/link/robot_status.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

class RobotDataPublisher {
 public:
  /// Of the model at the time of each message; gives nullptr without one.
  using Arm = std::function<std::shared_ptr<const arm::ArmModel>()>;

  /// Told at once, without what only a controller knows.
  RobotDataPublisher(const ros::NodeHandle& node, JointNames joint_names, Arm arm);

  /// Told again where the controller says something else of itself than before.
  void take(const link::RobotStatus& status);
  /// Its joints have other limits.
  void armChanged() { publish(); }

 private:
  void publish();

  JointNames joint_names_;
  Arm arm_;
  link::ControllerIdentity identity_;
  ros::Publisher topic_;
};

}  // namespace cobot_command::ros_adapter
