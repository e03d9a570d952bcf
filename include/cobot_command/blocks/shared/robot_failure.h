// What the robot itself is found to be in, as errors of the catalogue.
#pragma once

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::blocks {

/// What ends everything that is under way (16#99).
[[nodiscard]] Failure emergencyStop();

/// What a stopped project has to do with the loss of the link, for its error: that has another remedy. Each
/// frame may show it; it is told once.
void tellStoppedProject(const robot::RobotWatch& robot, Failure& loss);

/// 16#222 with the error that the robot shows. The way out is another one when the arm carries too much: the
/// next motion would only fail again.
[[nodiscard]] Failure robotError(const robot::RobotWatch& robot);

}  // namespace cobot_command::blocks
