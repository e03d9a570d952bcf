// Why nothing can be commanded, or why nothing moves, in plain words.
#pragma once

#include <string>

#include "robot_watch.h"

#include "cobot_command/link/script_link.h"

namespace cobot_command::blocks {

/// What the script port says, and what the status stream, which lives also without a project, knows besides.
[[nodiscard]] std::string diagnose(const link::ScriptLink& link, const RobotWatch& robot);

}  // namespace cobot_command::blocks
