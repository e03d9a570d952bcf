// Reads the triangles of STL files; text or binary.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// In the unit of the file, which does not specify it.
using Triangle = std::array<Eigen::Vector3d, 3>;

inline constexpr std::size_t kMostTriangles = 5000000;

/// Normals and attributes are ignored. A fault is a sentence: no triangles, more than kMostTriangles, a
/// truncated file, invalid coordinates.
[[nodiscard]] Result<std::vector<Triangle>, std::string> trianglesOfStl(std::string_view bytes);

}  // namespace cobot_command::cell
