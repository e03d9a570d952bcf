// Where the axes 5 and 6 cross, seen in the plane in which the joints 2 to 4 move.
#pragma once

#include <cmath>

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::arm {

/// s of doc/kinematics.md: the distance of the wrist centre in front of (> 0) or behind (< 0) axis 1, along
/// the direction in which joint 1 points [m].
[[nodiscard]] inline double wristCentreDistance(const DhLengths& lengths, const JointVector& joints) {
  const double upper_arm = joints[1];
  const double forearm = upper_arm + joints[2];
  const double wrist = forearm + joints[3];
  return lengths.a2 * std::sin(upper_arm) + lengths.a3 * std::sin(forearm) + lengths.d5 * std::sin(wrist);
}

}  // namespace cobot_command::arm
