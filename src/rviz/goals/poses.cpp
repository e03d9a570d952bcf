#include "goals/poses.h"

#include <cmath>

namespace cobot_command::rviz_plugin {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kMillimetre = 1e-3;
/// Next to ry = ±90 degrees only the sum, or the difference, of the other two counts: rx is 0 then.
constexpr double kGimbal = 1e-9;

}  // namespace

Eigen::Isometry3d toIsometry(const geometry_msgs::Pose& pose) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.translation() << pose.position.x, pose.position.y, pose.position.z;
  const Eigen::Quaterniond turn(pose.orientation.w, pose.orientation.x, pose.orientation.y,
                                pose.orientation.z);
  if (turn.squaredNorm() > 0) isometry.linear() = turn.normalized().toRotationMatrix();
  return isometry;
}

geometry_msgs::Pose toPose(const Eigen::Isometry3d& isometry) {
  const Eigen::Quaterniond turn(isometry.linear());
  geometry_msgs::Pose pose;
  pose.position.x = isometry.translation().x();
  pose.position.y = isometry.translation().y();
  pose.position.z = isometry.translation().z();
  pose.orientation.x = turn.x();
  pose.orientation.y = turn.y();
  pose.orientation.z = turn.z();
  pose.orientation.w = turn.w();
  return pose;
}

Eigen::Isometry3d toIsometry(const std::array<double, 6>& six) {
  using Axis = Eigen::AngleAxisd;
  using Vector = Eigen::Vector3d;
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.translation() << six[0] * kMillimetre, six[1] * kMillimetre, six[2] * kMillimetre;
  isometry.linear() = (Axis(six[5] * kDegree, Vector::UnitZ()) * Axis(six[4] * kDegree, Vector::UnitY()) *
                       Axis(six[3] * kDegree, Vector::UnitX()))
                          .toRotationMatrix();
  return isometry;
}

std::array<double, 6> toSix(const Eigen::Isometry3d& isometry) {
  const Eigen::Matrix3d r = isometry.linear();
  const double level = std::hypot(r(0, 0), r(1, 0));
  const double ry = std::atan2(-r(2, 0), level);
  const bool gimbal = level < kGimbal;
  const double rx = gimbal ? 0 : std::atan2(r(2, 1), r(2, 2));
  const double rz = gimbal ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0));
  const Eigen::Vector3d at = isometry.translation() / kMillimetre;
  return {at.x(), at.y(), at.z(), rx / kDegree, ry / kDegree, rz / kDegree};
}

}  // namespace cobot_command::rviz_plugin
