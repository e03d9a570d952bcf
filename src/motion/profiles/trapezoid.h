// The velocity profile of all that a script can ask for: to rest, from rest or from a speed, speeding up and
// slowing down equally.
#pragma once

#include "profiles/profile.h"

namespace cobot_command::motion {

/// Progress 0..1 over time. A motion is described by the time it would take at top speed all the way, and by
/// the time from rest to top speed; a motion too short for its top speed keeps the acceleration and is
/// triangular.
class Trapezoid final : public Profile {
 public:
  /// Below this time at top speed [s] there is nothing to move: the duration is zero.
  static constexpr double kNoTravel = 1e-12;

  /// Both in s and finite, travel >= 0, ramp > 0.
  Trapezoid(double travel, double ramp) : Trapezoid(travel, ramp, 0.0) {}
  /// Begins at `start_share` (0..1) of the top speed. Where the travel is too short to come to rest from it,
  /// it brakes as hard as it must.
  Trapezoid(double travel, double ramp, double start_share);
  /// At one speed from the start to the end, without any ramp; duration > 0 [s].
  [[nodiscard]] static Trapezoid steady(double duration);

  [[nodiscard]] double duration() const override { return duration_; }
  [[nodiscard]] double travel() const override { return travel_; }
  [[nodiscard]] double timeUp() const override { return up_; }
  /// From rest to rest at most half of the duration.
  [[nodiscard]] double timeDown() const override { return down_; }
  [[nodiscard]] bool startsAtRest() const override { return start_share_ == 0.0; }
  [[nodiscard]] double progress(double time) const override;
  [[nodiscard]] double rate(double time) const override;
  /// The ramps keep their time, so that their acceleration falls with the top speed.
  [[nodiscard]] double usableShare(double time, double excess) const override;
  /// When `progress` is reached [s], but not later than it begins to slow down.
  [[nodiscard]] double timeBeforeBraking(double progress) const;

 private:
  double travel_;
  double ramp_;  // from rest to top speed
  double start_share_;
  double up_;    // shorter than ramp_ in a triangle, and from a speed
  double down_;  // shorter than ramp_ in a triangle
  double duration_;
};

}  // namespace cobot_command::motion
