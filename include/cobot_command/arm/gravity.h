// Static joint torques from the weight of the arm and its payload.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// A mass concentrated in one point.
struct PointMass {
  double mass = 0;                                   ///< [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< [m]
};

/// Both masses combined; their centres are in the same frame.
[[nodiscard]] PointMass operator+(const PointMass& one, const PointMass& other);

/// The torques [Nm] that hold the arm at standstill, mounted upright. Positive if a joint pushes in its
/// positive direction. The masses are those of the URDF (without masses the torques are zero). `carried` is
/// the payload, in the flange.
[[nodiscard]] JointVector holdingTorques(const ArmModel& arm, const JointVector& joints,
                                         const PointMass& carried = {});

}  // namespace cobot_command::arm
