// What the robot is and what this interface can do, as a message.
#pragma once

#include <ros/time.h>

#include "cobot_command/RobotData.h"
#include "cobot_command/arm/arm_model.h"
#include "cobot_command/link/controller_identity.h"
#include "cobot_command/ros/shared/conversions.h"

namespace cobot_command::ros_adapter {

/// `arm`: nullptr without a model.
[[nodiscard]] cobot_command::RobotData toMessage(const arm::ArmModel* arm, const JointNames& names,
                                                 const link::ControllerIdentity& identity,
                                                 const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
