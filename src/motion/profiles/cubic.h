// A cubic between two values with given slopes; each component by itself.
#pragma once

#include <Eigen/Core>

namespace cobot_command::motion {

/// Over 0 <= time <= duration, the one with these values and slopes at its ends (Hermite).
template <int N>
class Cubic {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;

  Cubic(double duration, const Vector& from, const Vector& from_slope, const Vector& to,
        const Vector& to_slope)
      : start_(from), slope_(from_slope) {
    const Vector mean = (to - from) / duration;
    square_ = (3.0 * mean - 2.0 * from_slope - to_slope) / duration;
    cube_ = (from_slope + to_slope - 2.0 * mean) / (duration * duration);
  }

  [[nodiscard]] Vector at(double time) const {
    return start_ + time * (slope_ + time * (square_ + time * cube_));
  }
  [[nodiscard]] Vector slopeAt(double time) const {
    return slope_ + time * (2.0 * square_ + 3.0 * time * cube_);
  }
  [[nodiscard]] Vector curvatureAt(double time) const { return 2.0 * square_ + 6.0 * time * cube_; }
  /// Its coefficients of t, t^2, t^3 in one component.
  [[nodiscard]] double slope(Eigen::Index i) const { return slope_[i]; }
  [[nodiscard]] double square(Eigen::Index i) const { return square_[i]; }
  [[nodiscard]] double cube(Eigen::Index i) const { return cube_[i]; }

 private:
  Vector start_, slope_, square_, cube_;
};

}  // namespace cobot_command::motion
