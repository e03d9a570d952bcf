// Which voxels a capsule claims (cell.md, M9).
#pragma once

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/sweep/voxel_set.h"

namespace cobot_command::cell {

/// Puts into `set` all voxels of the grid with this edge [m, above 0] whose cube is within the radius of the
/// core of `grown` [m], and no others; what is nearer to the limit than 1e-9 m may be either. So `grown` is a
/// body with its radius grown by all that is to be kept clear of it. Precondition: all of it is finite, and
/// within kFarthestVoxel.
void claimCapsule(VoxelSet& set, const Capsule& grown, double edge);

}  // namespace cobot_command::cell
