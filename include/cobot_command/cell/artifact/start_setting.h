// What has to be set at a robot's controller before its program of the cell begins: a person does it at a
// real one, and a simulated one begins with it.
#pragma once

#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::cell {

/// The TCP with which its motions from home begin, in the flange [m]. Precondition: the artifact has that
/// robot.
[[nodiscard]] arm::Pose startTcp(const Artifact& artifact, RobotIndex robot);

/// The highest project speed for which the claims hold [%, a multiple of 5].
[[nodiscard]] int highestProjectSpeed(const Artifact& artifact);

}  // namespace cobot_command::cell
