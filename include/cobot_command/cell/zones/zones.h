// Spaces that robots share: each may be held by one of them at a time (cell.md, M11 and M12).
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/model/cell_program.h"
#include "cobot_command/cell/sweep/voxel_set.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

struct Zone {
  std::string name;               ///< "Z1", "Z2", ...
  std::vector<RobotIndex> users;  ///< ascending
  VoxelSet voxels;
};

/// What is in the claims of two robots, in parts that hang together; those longer than `zone_size` are cut in
/// the middle, those of a few voxels put to what is near, and those of different users that share
/// `zone_overlap` of the smaller one are united. Numbered by the names of their users, then by their lowest
/// voxels. A fault is a sentence: there are more than `max_zones`.
[[nodiscard]] Result<std::vector<Zone>, std::string> findZones(const std::vector<RobotClaim>& claims,
                                                               const Parameters& parameters);

/// "x -120..140, y -80..60, z 300..720 mm": its box.
[[nodiscard]] std::string boxOf(const Zone& zone, double voxel);

}  // namespace cobot_command::cell
