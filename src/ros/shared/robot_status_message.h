// What the status stream tells of the robot, as its message.
#pragma once

#include <ros/time.h>

#include "cobot_command/RobotStatus.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] cobot_command::RobotStatus toMessage(const link::RobotStatus& status, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
