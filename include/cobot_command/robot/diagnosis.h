// Why nothing can be commanded, or why nothing moves, in plain words.
#pragma once

#include <string>

#include "cobot_command/link/script_link.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

/// What the script port says, and what the status stream, which lives also without a project, knows besides.
[[nodiscard]] std::string diagnose(const link::ScriptLink& link, const RobotWatch& robot);

/// Of a robot that can be commanded: what the status stream does not show of all that "ready" stands for;
/// empty: nothing.
[[nodiscard]] std::string whatIsUnseen(const RobotWatch& robot);

}  // namespace cobot_command::robot
