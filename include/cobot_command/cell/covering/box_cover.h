// Covers a mesh with boxes. Cells accept no meshes, because the proofs need exactly known bodies
// (doc/cell.md).
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/covering/stl.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

inline constexpr std::size_t kMostCoverCells = 2000000;

/// Boxes that contain every point of every triangle. They consist of cells with this edge [mm, above 0],
/// without the unused parts of the outer cells. They are at least 1 mm thick, with bounds in whole tenths.
/// Enclosed volume is filled if that gives fewer boxes. A fault is a sentence: more than kMostCoverCells
/// would be needed, or a corner is too far from the origin.
[[nodiscard]] Result<std::vector<AlignedBox>, std::string> boxesOver(const std::vector<Triangle>& triangles,
                                                                     double edge);

/// As `shapes` of a cell file.
[[nodiscard]] std::string shapesText(const std::vector<AlignedBox>& boxes);

}  // namespace cobot_command::cell
