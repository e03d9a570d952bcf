// What the joints must hold: the weight of the arm and of what it carries.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// A mass, as if it were all in one point.
struct PointMass {
  double mass = 0;                                   ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
};

/// Both together; the frame of their centres is the same.
[[nodiscard]] PointMass operator+(const PointMass& one, const PointMass& other);

/// The torques [Nm] with which the joints hold the arm still, upright on its base: positive where a joint
/// pushes in its own direction. The masses are those of the URDF (none: nothing to hold), `carried` is in the
/// flange.
[[nodiscard]] JointVector holdingTorques(const ArmModel& arm, const JointVector& joints,
                                         const PointMass& carried = {});

}  // namespace cobot_command::arm
