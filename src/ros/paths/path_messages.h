// How a path goes, as a message.
#pragma once

#include <ros/time.h>

#include "cobot_command/PathStatus.h"
#include "cobot_command/blocks/load_path.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] cobot_command::PathStatus toMessage(const blocks::PathStatus& status, const ros::Time& stamp);

}  // namespace cobot_command::ros_adapter
