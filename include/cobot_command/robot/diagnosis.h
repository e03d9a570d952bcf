// Why no command is possible, or why nothing moves, in plain words.
#pragma once

#include <string>

#include "cobot_command/link/script_link.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

/// Combines the state of the script port with the status stream, which also works without a running project.
[[nodiscard]] std::string diagnose(const link::ScriptLink& link, const RobotWatch& robot);

/// For a robot that accepts commands: the parts of "ready" that the status stream does not show; empty: none.
[[nodiscard]] std::string whatIsUnseen(const RobotWatch& robot);

}  // namespace cobot_command::robot
