// The shapes of which cells are described: of tools, parts, obstacles and mechanisms (cell.md, M3).
//
// In SI [m, rad]; the files of cells have mm and degrees.
#pragma once

#include <cstddef>
#include <variant>

#include <Eigen/Core>

#include "cobot_command/arm/types.h"

namespace cobot_command::cell {

/// All points within `radius` of the segment.
struct CapsuleShape {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

struct SphereShape {
  double radius = 0.0;
};

/// Along z, its middle at the origin.
struct CylinderShape {
  double radius = 0.0;
  double length = 0.0;
};

/// Its middle at the origin, its edges along the axes.
struct BoxShape {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// Of one thing in the file of a cell.
inline constexpr std::size_t kMostShapes = 200;

struct Shape {
  std::variant<CapsuleShape, SphereShape, CylinderShape, BoxShape> kind;
  arm::Pose at = arm::Pose::Identity();  ///< seen from what it belongs to
};

}  // namespace cobot_command::cell
