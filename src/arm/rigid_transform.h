// Guards the edge of the kinematics: is this a pose at all?
#pragma once

#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// Finite, and its linear part is a rotation up to 1e-6: single precision passes, a mirror image does not.
[[nodiscard]] inline bool isRigidTransform(const Pose& pose) {
  constexpr double kAllowed = 1e-6;
  const Eigen::Matrix3d r = pose.linear();
  // Not "greater than": a NaN must be refused too.
  const double distance = (r.transpose() * r - Eigen::Matrix3d::Identity()).squaredNorm();
  return distance <= kAllowed * kAllowed && r.determinant() > 0 && pose.translation().allFinite();
}

}  // namespace cobot_command::arm
