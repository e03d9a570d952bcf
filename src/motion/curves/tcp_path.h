// Where the TCP goes, without time: a straight line or an arc, with a turn about one axis in step with it.
#pragma once

#include <cmath>

#include "curves/tcp_curve.h"

namespace cobot_command::motion {

/// A value.
class TcpPath final : public TcpCurve {
 public:
  /// Straight, turning the shortest way.
  [[nodiscard]] static TcpPath line(const arm::Pose& from, const arm::Pose& to);

  /// From `from` by `angle` [rad] about the axis through `centre` along the unit vector `normal`, turning the
  /// shortest way to `end_orientation` meanwhile.
  [[nodiscard]] static TcpPath arc(const arm::Pose& from, const Eigen::Vector3d& centre,
                                   const Eigen::Vector3d& normal, double angle,
                                   const Eigen::Matrix3d& end_orientation);

  [[nodiscard]] double length() const override { return length_; }  ///< [m]
  [[nodiscard]] double turn() const override { return turn_; }      ///< [rad], 0..pi

  [[nodiscard]] arm::Pose at(double progress) const override;
  [[nodiscard]] PathRate rateAt(double progress) const override;
  /// The same everywhere: none on a line, that towards the centre on an arc. The turn is about one axis.
  [[nodiscard]] RateChange rateChange(double /*from*/, double /*to*/) const override {
    return {std::abs(arc_angle_) * (arc_angle_ == 0.0 ? 0.0 : length_), 0.0};
  }

 private:
  TcpPath(const arm::Pose& from, const Eigen::Matrix3d& end_orientation);

  // Line: origin_ + progress along_. Arc: origin_ + sin(phi) along_ - (1 - cos(phi)) outward_.
  Eigen::Vector3d origin_;
  Eigen::Vector3d along_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d outward_ = Eigen::Vector3d::Zero();
  double arc_angle_ = 0.0;  // 0: a line
  double length_ = 0.0;
  Eigen::Matrix3d orientation_;
  Eigen::Vector3d turn_axis_;  // in the frame of the path
  double turn_ = 0.0;
};

}  // namespace cobot_command::motion
