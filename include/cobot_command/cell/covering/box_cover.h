// Boxes that cover a mesh, as cells take no meshes: what is proved of a cell needs bodies that are known
// exactly (cell.md, S1).
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/covering/stl.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

inline constexpr std::size_t kMostCoverCells = 2000000;

/// Every point of every triangle is inside of a box. The boxes consist of cells with this edge [mm, above 0],
/// less what is left free of the outer ones, are at least 1 mm thick, and begin and end at whole tenths. What
/// a mesh closes in is filled where that makes fewer of them. A fault is a sentence: there would be more than
/// kMostCoverCells, or a corner is too far out.
[[nodiscard]] Result<std::vector<AlignedBox>, std::string> boxesOver(const std::vector<Triangle>& triangles,
                                                                     double edge);

/// As `shapes` of a cell file.
[[nodiscard]] std::string shapesText(const std::vector<AlignedBox>& boxes);

}  // namespace cobot_command::cell
