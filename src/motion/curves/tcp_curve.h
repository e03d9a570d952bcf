// Where a TCP goes, without time. What it needs to be followed; lines and arcs, chains of lines and splines
// are such curves.
#pragma once

#include <memory>

#include "cobot_command/arm/types.h"

namespace cobot_command::motion {

/// How a TCP moves for each unit of progress: rows 0..2 linear [m], rows 3..5 angular [rad], in the frame of
/// the curve.
using PathRate = Eigen::Matrix<double, 6, 1>;

/// At most how much a PathRate changes for each unit of progress, as lengths of its two vectors [m, rad].
/// Infinite where it jumps.
struct RateChange {
  double linear = 0.0;
  double angular = 0.0;
};

/// From progress 0 to 1, in any one frame. Immutable.
class TcpCurve {
 public:
  virtual ~TcpCurve() = default;

  /// At least the length of the way [m] and the sum of the turns [rad].
  [[nodiscard]] virtual double length() const = 0;
  [[nodiscard]] virtual double turn() const = 0;

  [[nodiscard]] virtual arm::Pose at(double progress) const = 0;
  [[nodiscard]] virtual PathRate rateAt(double progress) const = 0;
  /// Anywhere between two places, `from` < `to`. Where it is finite, rateAt() is the derivative of at().
  [[nodiscard]] virtual RateChange rateChange(double from, double to) const = 0;
};

using TcpCurvePtr = std::shared_ptr<const TcpCurve>;

/// A rotation as the axis times the angle [rad], 0..pi.
[[nodiscard]] inline Eigen::Vector3d turnBetween(const Eigen::Matrix3d& from, const Eigen::Matrix3d& to) {
  const Eigen::AngleAxisd turn(Eigen::Quaterniond(to).normalized() *
                               Eigen::Quaterniond(from).normalized().conjugate());
  return turn.angle() * turn.axis();
}

/// The other way round.
[[nodiscard]] inline Eigen::Matrix3d turnedBy(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) {
    return Eigen::Matrix3d::Identity();
  }
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

}  // namespace cobot_command::motion
