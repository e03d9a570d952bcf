// The bodies of an arm, as the <collision> elements of its URDF describe them.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"

namespace cobot_command::arm {

/// Along z, its middle at the origin [m].
struct CollisionCylinder {
  double radius = 0;
  double length = 0;
};

/// Its middle at the origin, its edges along the axes [m].
struct CollisionBox {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// Its middle at the origin [m].
struct CollisionSphere {
  double radius = 0;
};

struct CollisionShape {
  std::size_t link = 0;        ///< 0 to 6: that of LinkFrames with which it moves
  Pose at = Pose::Identity();  ///< in the frame of that link
  std::variant<CollisionCylinder, CollisionBox, CollisionSphere> kind;
  std::string link_name;  ///< of the URDF
};

/// All of them, link by link in the order of their names, also those of links that are fixed to a link of the
/// arm, as a camera. Refused when the text is no URDF of one arm, and where a shape cannot be told: a mesh, a
/// length that is not finite and positive, a link with a body that is not fixed to a link of the arm.
[[nodiscard]] Result<std::vector<CollisionShape>, ModelError> collisionShapes(const std::string& urdf);

}  // namespace cobot_command::arm
