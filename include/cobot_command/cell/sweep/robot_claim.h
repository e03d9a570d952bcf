// The voxels that a robot claims while its joints stay in a box (doc/cell.md).
#pragma once

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/sweep/voxel_set.h"

namespace cobot_command::cell {

/// Inserts into `set` all voxels of the grid with this edge [m, above 0] that are within `clearance` [m] of a
/// point of the robot at any joints in the box. `placed` is the robot at the centre of the box. `half_widths`
/// [rad, not negative] are those of the box, including the permitted deviation of the joints from their path.
/// A point of an inserted voxel is at most twice displacementBound(), plus the clearance, plus sqrt(3) times
/// the edge from a body that is there at some time.
void claimRobot(VoxelSet& set, const RobotBodies& robot, const PlacedRobot& placed,
                const arm::JointVector& half_widths, double clearance, double edge);

}  // namespace cobot_command::cell
