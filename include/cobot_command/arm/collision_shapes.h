// The collision shapes of an arm, from the <collision> elements of its URDF.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"

namespace cobot_command::arm {

/// Along z, centred at the origin [m].
struct CollisionCylinder {
  double radius = 0;
  double length = 0;
};

/// Centred at the origin, edges along the axes [m].
struct CollisionBox {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
};

/// Centred at the origin [m].
struct CollisionSphere {
  double radius = 0;
};

struct CollisionShape {
  std::size_t link = 0;        ///< 0 to 6: index of the link in LinkFrames that it moves with
  Pose at = Pose::Identity();  ///< in the frame of that link
  std::variant<CollisionCylinder, CollisionBox, CollisionSphere> kind;
  std::string link_name;  ///< in the URDF
};

/// All shapes, link by link in the order of the link names, including links fixed to a link of the arm, such
/// as a camera. Refused if the text is not a URDF of one arm, or if a shape cannot be determined: a mesh, a
/// length that is not finite and positive, a link with a shape that is not fixed to a link of the arm.
[[nodiscard]] Result<std::vector<CollisionShape>, ModelError> collisionShapes(const std::string& urdf);

}  // namespace cobot_command::arm
