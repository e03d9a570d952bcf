#include "curves/tcp_path.h"

#include <cmath>

namespace cobot_command::motion {

TcpPath::TcpPath(const arm::Pose& from, const Eigen::Matrix3d& end_orientation)
    : origin_(from.translation()) {
  const Eigen::Quaterniond start = Eigen::Quaterniond(from.linear()).normalized();
  const Eigen::Quaterniond end = Eigen::Quaterniond(end_orientation).normalized();
  const Eigen::AngleAxisd turn(end * start.conjugate());  // angle in 0..pi: the shortest way
  orientation_ = start.toRotationMatrix();
  turn_axis_ = turn.axis();
  turn_ = turn.angle();
}

TcpPath TcpPath::line(const arm::Pose& from, const arm::Pose& to) {
  TcpPath path(from, to.linear());
  path.along_ = to.translation() - from.translation();
  path.length_ = path.along_.norm();
  return path;
}

TcpPath TcpPath::arc(const arm::Pose& from, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal,
                     double angle, const Eigen::Matrix3d& end_orientation) {
  TcpPath path(from, end_orientation);
  path.outward_ = from.translation() - centre;
  path.along_ = normal.cross(path.outward_);
  path.arc_angle_ = angle;
  path.length_ = std::abs(angle) * path.outward_.norm();
  return path;
}

arm::Pose TcpPath::at(double progress) const {
  arm::Pose pose = arm::Pose::Identity();
  if (arc_angle_ == 0.0) {
    pose.translation() = origin_ + progress * along_;
  } else {
    const double phi = progress * arc_angle_;
    const double half = std::sin(0.5 * phi);  // 1 - cos(phi) loses all digits where phi is small
    pose.translation() = origin_ + std::sin(phi) * along_ - (2.0 * half * half) * outward_;
  }
  pose.linear() = Eigen::AngleAxisd(progress * turn_, turn_axis_).toRotationMatrix() * orientation_;
  return pose;
}

PathRate TcpPath::rateAt(double progress) const {
  PathRate rate;
  rate.tail<3>() = turn_ * turn_axis_;
  if (arc_angle_ == 0.0) {
    rate.head<3>() = along_;
  } else {
    const double phi = progress * arc_angle_;
    rate.head<3>() = arc_angle_ * (std::cos(phi) * along_ - std::sin(phi) * outward_);
  }
  return rate;
}

}  // namespace cobot_command::motion
