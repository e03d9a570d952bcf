// Controller settings that a robot needs before its program of the cell starts. An operator sets them on a
// real controller; a simulated one starts with them.
#pragma once

#include "cobot_command/cell/artifact/artifact.h"

namespace cobot_command::cell {

/// The TCP at the start of its motions from home, in the flange [m]. Precondition: the artifact has that
/// robot.
[[nodiscard]] arm::Pose startTcp(const Artifact& artifact, RobotIndex robot);

/// The highest project speed for which the claims are valid [%, a multiple of 5].
[[nodiscard]] int highestProjectSpeed(const Artifact& artifact);

}  // namespace cobot_command::cell
