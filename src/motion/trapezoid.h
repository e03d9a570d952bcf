// The one velocity profile: from rest to rest, speeding up and slowing down equally.
#pragma once

namespace cobot_command::motion {

/// Progress 0..1 over time. A motion is described by the time it would take at top speed all the way, and by
/// the time from rest to top speed; a motion too short for its top speed keeps the acceleration and is
/// triangular.
class Trapezoid {
 public:
  /// Below this time at top speed [s] there is nothing to move: the duration is zero.
  static constexpr double kNoTravel = 1e-12;

  /// Both in s and finite, travel >= 0, ramp > 0.
  Trapezoid(double travel, double ramp);

  /// [s]
  [[nodiscard]] double duration() const { return duration_; }
  /// From rest to its highest speed, and back [s]; at most half of the duration.
  [[nodiscard]] double rampTime() const { return ramp_used_; }
  /// Precondition of the next three: 0 <= time <= duration() [s], travel >= kNoTravel.
  [[nodiscard]] double progress(double time) const;
  /// [1/s]
  [[nodiscard]] double rate(double time) const;
  /// The speed as a share (0..1) of the top speed.
  [[nodiscard]] double shareOfTopSpeed(double time) const { return rate(time) * travel_; }

 private:
  double travel_;
  double ramp_;       // from rest to top speed
  double ramp_used_;  // shorter than ramp_ in a triangle
  double duration_;
};

}  // namespace cobot_command::motion
