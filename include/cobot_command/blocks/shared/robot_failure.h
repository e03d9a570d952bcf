// Errors of the catalogue for the state of the robot itself.
#pragma once

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::blocks {

/// Ends all running commands (16#99).
[[nodiscard]] Failure emergencyStop();

/// Adds to the error of a lost link that the project was stopped, which has another remedy. Each frame may
/// show it; it is added once.
void tellStoppedProject(const robot::RobotWatch& robot, Failure& loss);

/// 16#222 with the error that the robot shows. The remedy differs if the payload is too heavy, because the
/// next motion would fail again.
[[nodiscard]] Failure robotError(const robot::RobotWatch& robot);

}  // namespace cobot_command::blocks
