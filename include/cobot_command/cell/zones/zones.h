// Spaces that several robots share. One robot at a time may hold each (doc/cell.md).
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

/// The connected parts of the space in the claims of two robots. Parts longer than `zone_size` are cut in the
/// middle, parts of a few voxels are merged with a near part, and parts of different users that share
/// `zone_overlap` of the smaller one are united. Numbered by the names of their users, then by their lowest
/// voxels. A fault is a sentence: there are more than `max_zones`.
[[nodiscard]] Result<std::vector<Zone>, std::string> findZones(const std::vector<RobotClaim>& claims,
                                                               const Parameters& parameters);

/// The bounding box: "x -120..140, y -80..60, z 300..720 mm".
[[nodiscard]] std::string boxOf(const Zone& zone, double voxel);

}  // namespace cobot_command::cell
