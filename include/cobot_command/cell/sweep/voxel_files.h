// Writes sets of voxels as files for other programs: point clouds and OctoMap maps (doc/cell.md).
//
// The same voxels give the same bytes.
#pragma once

#include <string>

#include "cobot_command/cell/sweep/voxel_set.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// PLY, binary, for MeshLab, CloudCompare, Open3D and PCL: one vertex at the centre of each voxel [m], sorted
/// by x, then y, then z. `about` is a line of its header.
[[nodiscard]] std::string toPly(const VoxelSet& voxels, double edge, const std::string& about);

/// A map has 2^16 voxels along each axis, half of them on each side of the origin.
inline constexpr std::int32_t kFarthestOfOctomap = 1 << 15;

/// An OctoMap tree (.bt): the voxels are occupied, all others are unknown; eight full voxels are merged.
/// `edge` is its resolution [m]. A fault is a sentence: a voxel is outside the range of such a tree.
[[nodiscard]] Result<std::string, std::string> toOctomap(const VoxelSet& voxels, double edge,
                                                         const std::string& about);

}  // namespace cobot_command::cell
