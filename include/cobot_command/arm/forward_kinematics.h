// Pose and velocity of the flange for given joints. Closed form; the tests verify it with KDL.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/types.h"

namespace cobot_command::arm {

/// Pose of the flange in the robot base [m].
[[nodiscard]] Pose forwardKinematics(const ArmModel& arm, const JointVector& joints);

/// Geometric Jacobian of the flange origin in the robot base.
[[nodiscard]] Jacobian jacobianAt(const ArmModel& arm, const JointVector& joints);

/// Distance of a posture from each singularity; exactly on a singularity its value is zero (TM 4.1: det J =
/// a2 a3 sin J3 sin J5 s).
struct SingularityDistance {
  double shoulder = 0;  ///< |s|: distance of the wrist centre from the shoulder cylinder's tangent plane [m]
  double elbow = 0;     ///< |sin J3|
  double wrist = 0;     ///< |sin J5|
};
[[nodiscard]] SingularityDistance singularityDistance(const ArmModel& arm, const JointVector& joints);

}  // namespace cobot_command::arm
