// Sets of voxels as files that other programs show: point clouds, and maps of OctoMap (cell.md, S3).
//
// The same voxels give the same bytes.
#pragma once

#include <string>

#include "cobot_command/cell/sweep/voxel_set.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// PLY, binary, which MeshLab, CloudCompare, Open3D and PCL read: a vertex for the centre of each voxel [m],
/// by x, then y, then z. `about` is a line of its head.
[[nodiscard]] std::string toPly(const VoxelSet& voxels, double edge, const std::string& about);

/// A map has 2^16 voxels along each axis, half of them on either side of the origin.
inline constexpr std::int32_t kFarthestOfOctomap = 1 << 15;

/// A tree of OctoMap (.bt): the voxels are occupied, all else is unknown; eight that are all full are one.
/// `edge` is its resolution [m]. A fault is a sentence: a voxel is beyond what such a tree can hold.
[[nodiscard]] Result<std::string, std::string> toOctomap(const VoxelSet& voxels, double edge,
                                                         const std::string& about);

}  // namespace cobot_command::cell
