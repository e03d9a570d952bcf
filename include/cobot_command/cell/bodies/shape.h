// The shapes in the description of a cell: of tools, parts, obstacles and mechanisms (doc/cell.md).
//
// In SI [m, rad]; cell files have mm and degrees.
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

/// Along z, centred at the origin.
struct CylinderShape {
  double radius = 0.0;
  double length = 0.0;
};

/// Centred at the origin, edges along the axes.
struct BoxShape {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// Most shapes of one object in a cell file.
inline constexpr std::size_t kMostShapes = 200;

struct Shape {
  std::variant<CapsuleShape, SphereShape, CylinderShape, BoxShape> kind;
  arm::Pose at = arm::Pose::Identity();  ///< in the frame of the object
};

}  // namespace cobot_command::cell
