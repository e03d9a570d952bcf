// The voxels that a capsule claims (doc/cell.md).
#pragma once

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/sweep/voxel_set.h"

namespace cobot_command::cell {

/// Inserts into `set` exactly the voxels of the grid with this edge [m, above 0] whose cube is within the
/// radius of the core of `grown` [m]. Voxels within 1e-9 m of the limit may or may not be inserted. `grown`
/// is a body whose radius includes the required clearance. Precondition: all values are finite, and within
/// kFarthestVoxel.
void claimCapsule(VoxelSet& set, const Capsule& grown, double edge);

}  // namespace cobot_command::cell
