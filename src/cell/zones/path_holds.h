// The holds of one zone on one path.
#pragma once

#include <vector>

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/zones/holds.h"

namespace cobot_command::cell {

/// A zone that is free for less is not given back in between.
inline constexpr Duration kLeastRest = std::chrono::milliseconds(300);

struct PathInZone {
  const PlannedPath* path;  ///< none: of a mechanism, which makes one frame of it
  const PathClaim& claim;
  const VoxelSet& voxels;
  bool at_begin = false;  ///< the station that the path comes from is in the zone
  bool at_end = false;    ///< and that it leads to
};

/// In their order; Hold::zone is left to who asks.
[[nodiscard]] std::vector<Hold> holdsOnPath(const PathInZone& in_zone);

}  // namespace cobot_command::cell
