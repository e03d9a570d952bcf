// How far the bodies of a robot can move while its joints stay in a box (doc/cell.md).
#pragma once

#include <cstddef>

#include "cobot_command/arm/link_chain.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/robot_bodies.h"

namespace cobot_command::cell {

/// Largest distance [m] of any point of this body from its position at the centre of the box, for all joints
/// in the box. `capsule` and `axes` are at the centre, `link` is that of the body, `half_widths` [rad, not
/// negative] are those of the box.
[[nodiscard]] double displacementBound(const Capsule& capsule, std::size_t link, const arm::JointAxes& axes,
                                       const arm::JointVector& half_widths);

/// The largest bound of all bodies of a robot; `placed` is the robot at the centre of the box.
[[nodiscard]] double largestDisplacement(const RobotBodies& robot, const PlacedRobot& placed,
                                         const arm::JointVector& half_widths);

}  // namespace cobot_command::cell
