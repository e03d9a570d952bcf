// What the status stream tells of the robot, as its message.
#pragma once

#include <optional>

#include <ros/time.h>

#include "cobot_command/RobotStatus.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::ros_adapter {

/// `moving`: nothing: not known.
[[nodiscard]] cobot_command::RobotStatus toMessage(const link::RobotStatus& status,
                                                   const std::optional<bool>& moving, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
