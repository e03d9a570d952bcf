// What the motion tests share: models, postures in degrees, and measures of how far two poses are apart.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {

inline arm::ArmModel model(const std::string& name = "tm5-900") {
  return *arm::ArmModel::named(name);
}

inline arm::JointVector degrees(double j1, double j2, double j3, double j4, double j5, double j6) {
  return arm::toJointVector({j1, j2, j3, j4, j5, j6});
}

/// A posture far from every singularity and limit.
inline arm::JointVector workingPosture() {
  return degrees(10, 15, 80, -5, 85, 20);
}

inline Duration milliseconds(int count) {
  return std::chrono::milliseconds(count);
}

inline arm::Pose tcpAt(const arm::ArmModel& arm, const arm::JointVector& joints, const Setting& setting) {
  return setting.base.inverse() * arm::forwardKinematics(arm, joints) * setting.tcp;
}

/// The pose moved by x, y, z [m] and turned by `angle` [rad] about `axis`, both in the frame of the pose's
/// base; the position is not turned.
inline arm::Pose moved(const arm::Pose& pose, double x, double y, double z, double angle = 0.0,
                       const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ()) {
  arm::Pose result = pose;
  result.translation() += Eigen::Vector3d(x, y, z);
  result.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix() * pose.linear();
  return result;
}

inline double distance(const arm::Pose& a, const arm::Pose& b) {
  return (a.translation() - b.translation()).norm();
}

/// Largest difference of an entry of the rotation matrices: close to the angle where both are small.
inline double turnError(const arm::Pose& a, const arm::Pose& b) {
  return (a.linear() - b.linear()).cwiseAbs().maxCoeff();
}

/// A base and a TCP that are not trivial.
inline Setting displacedSetting() {
  Setting setting;
  setting.base = moved(arm::Pose::Identity(), 0.1, -0.2, 0.05, 0.7, {1, 2, 3});
  setting.tcp = moved(arm::Pose::Identity(), 0.02, -0.03, 0.15, -0.4, {2, -1, 1});
  return setting;
}

/// The trajectory, or a failed test that names the refusal.
inline TrajectoryPtr planned(const Result<TrajectoryPtr, Refusal>& result) {
  if (!result) {
    ADD_FAILURE() << toString(result.error().reason) << ": " << result.error().message;
    return nullptr;
  }
  return *result;
}

}  // namespace cobot_command::motion
