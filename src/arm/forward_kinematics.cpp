#include "cobot_command/arm/forward_kinematics.h"

#include <cmath>

#include "wrist_centre.h"

namespace cobot_command::arm {
namespace {

using Eigen::Vector3d;

/// The arm in a posture, as far as the flange axis. Names as in doc/kinematics.md.
struct Posture {
  Vector3d across;       ///< axes 2, 3 and 4
  Vector3d wrist_2;      ///< axis 5
  Vector3d wrist_3;      ///< axis 6, out of the flange
  Vector3d flange_side;  ///< x of the flange while joint 6 is at zero
  Vector3d elbow;        ///< a point on axis 3, seen from the shoulder [m]
  Vector3d wrist_1;      ///< a point on axis 4, seen from the shoulder [m]
  Vector3d flange;       ///< seen from the shoulder [m]
};

Posture postureAt(const DhLengths& lengths, const JointVector& joints) {
  const double c1 = std::cos(joints[0]);
  const double s1 = std::sin(joints[0]);
  // Directions in the plane of the joints 2 to 4, by their angle from the vertical.
  const auto in_plane = [c1, s1](double sine, double cosine) {
    return Vector3d(sine * c1, sine * s1, cosine);
  };
  const double upper_arm = joints[1];
  const double forearm = upper_arm + joints[2];
  const double wrist = forearm + joints[3];
  const double c = std::cos(wrist);
  const double s = std::sin(wrist);
  const double c5 = std::cos(joints[4]);
  const double s5 = std::sin(joints[4]);

  Posture posture;
  posture.across = Vector3d(-s1, c1, 0);
  posture.wrist_2 = in_plane(s, c);
  const Vector3d forward = in_plane(c, -s);
  posture.flange_side = c5 * forward + s5 * posture.across;
  posture.wrist_3 = s5 * forward - c5 * posture.across;
  posture.elbow = lengths.a2 * in_plane(std::sin(upper_arm), std::cos(upper_arm));
  posture.wrist_1 = posture.elbow + lengths.a3 * in_plane(std::sin(forearm), std::cos(forearm));
  posture.flange = posture.wrist_1 + lengths.d4 * posture.across + lengths.d5 * posture.wrist_2 +
                   lengths.d6 * posture.wrist_3;
  return posture;
}

}  // namespace

Pose forwardKinematics(const ArmModel& arm, const JointVector& joints) {
  const Posture posture = postureAt(arm.lengths(), joints);
  const double c6 = std::cos(joints[5]);
  const double s6 = std::sin(joints[5]);
  Pose flange = Pose::Identity();
  flange.linear().col(0) = c6 * posture.flange_side + s6 * posture.wrist_2;
  flange.linear().col(1) = c6 * posture.wrist_2 - s6 * posture.flange_side;
  flange.linear().col(2) = posture.wrist_3;
  flange.translation() = posture.flange + Vector3d(0, 0, arm.lengths().d1);
  return flange;
}

Jacobian jacobianAt(const ArmModel& arm, const JointVector& joints) {
  const Posture posture = postureAt(arm.lengths(), joints);
  Jacobian jacobian;
  const auto set_column = [&](Eigen::Index joint, const Vector3d& axis, const Vector3d& lever) {
    jacobian.col(joint) << axis.cross(lever), axis;
  };
  set_column(0, Vector3d::UnitZ(), posture.flange);
  set_column(1, posture.across, posture.flange);
  set_column(2, posture.across, posture.flange - posture.elbow);
  set_column(3, posture.across, posture.flange - posture.wrist_1);
  set_column(4, posture.wrist_2, arm.lengths().d6 * posture.wrist_3);
  set_column(5, posture.wrist_3, Vector3d::Zero());
  return jacobian;
}

SingularityDistance singularityDistance(const ArmModel& arm, const JointVector& joints) {
  return {std::abs(wristCentreDistance(arm.lengths(), joints)), std::abs(std::sin(joints[2])),
          std::abs(std::sin(joints[4]))};
}

}  // namespace cobot_command::arm
