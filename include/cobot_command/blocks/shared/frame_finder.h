// The core's question where a frame is: the only thing that it has to ask while it works.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cobot_command/arm/types.h"

namespace cobot_command::blocks {

/// Where a frame is now, in the robot base; nothing when that is not known (any more). Has to answer at once.
using FrameFinder = std::function<std::optional<arm::Pose>(const std::string& frame)>;

}  // namespace cobot_command::blocks
