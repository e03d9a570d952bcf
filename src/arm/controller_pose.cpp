#include "cobot_command/arm/controller_pose.h"

#include <algorithm>
#include <cmath>

#include "cobot_command/common/units.h"

namespace cobot_command::arm {
namespace {

/// Below this cosine of RY only RZ -+ RX is determined. Small enough for the error that RZ := 0 makes here to
/// vanish, large enough for the rounding of a pose to stay below it.
constexpr double kGimbalLock = 1e-10;

/// In (-180, 180], without a negative zero.
double reportedDegrees(double radians) {
  const double degrees = radToDeg(radians);
  return degrees <= -180.0 ? degrees + 360.0 : degrees + 0.0;
}

}  // namespace

Pose toPose(const ControllerPose& pose_mm_deg) {
  Pose pose = Pose::Identity();
  pose.translation() << mmToM(pose_mm_deg[0]), mmToM(pose_mm_deg[1]), mmToM(pose_mm_deg[2]);
  pose.linear() = (Eigen::AngleAxisd(degToRad(pose_mm_deg[5]), Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(degToRad(pose_mm_deg[4]), Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(degToRad(pose_mm_deg[3]), Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

ControllerPose toControllerPose(const Pose& pose) {
  const auto r = pose.linear();
  const double cos_ry = std::hypot(r(0, 0), r(1, 0));
  const double ry = std::atan2(-r(2, 0), cos_ry);
  const double rz = cos_ry > kGimbalLock ? std::atan2(r(1, 0), r(0, 0)) : 0.0;
  // What remains after RZ is turned back: near gimbal lock, where RZ is badly determined, RX then makes up
  // for it.
  const double sin_rz = std::sin(rz);
  const double cos_rz = std::cos(rz);
  const double rx = std::atan2(sin_rz * r(0, 2) - cos_rz * r(1, 2), cos_rz * r(1, 1) - sin_rz * r(0, 1));
  const auto p = pose.translation();
  return {mToMm(p.x()) + 0.0,  mToMm(p.y()) + 0.0,  mToMm(p.z()) + 0.0,
          reportedDegrees(rx), reportedDegrees(ry), reportedDegrees(rz)};
}

JointVector toJointVector(const ControllerJoints& joints_deg) {
  JointVector joints;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    joints[static_cast<Eigen::Index>(i)] = degToRad(joints_deg[i]);
  }
  return joints;
}

ControllerJoints toControllerJoints(const JointVector& joints) {
  ControllerJoints joints_deg{};
  for (std::size_t i = 0; i < kJointCount; ++i) {
    joints_deg[i] = radToDeg(joints[static_cast<Eigen::Index>(i)]) + 0.0;
  }
  return joints_deg;
}

std::array<double, 6> asWritten(const std::array<double, 6>& values) {
  constexpr double kMillion = 1e6;
  std::array<double, 6> written{};
  std::transform(values.begin(), values.end(), written.begin(),
                 [](double value) { return std::round(value * kMillion) / kMillion + 0.0; });
  return written;
}

bool isSamePose(const Pose& a, const Pose& b) {
  constexpr double kSame = 1e-4;  // [m], and of the rotation matrix
  return a.isApprox(b, kSame);
}

}  // namespace cobot_command::arm
