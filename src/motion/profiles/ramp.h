// How a speed grows from rest to its top: in closed form, for all laws and any share of varying acceleration.
#pragma once

#include "cobot_command/motion/command.h"

namespace cobot_command::motion {

/// The time of a ramp is its unit here, and its top speed: speed() and way() of a share (0..1) of that time.
/// Point-symmetric about its middle. A value.
class Ramp {
 public:
  /// `varying`: the share (0..1) of its time for which the acceleration varies.
  Ramp(SpeedLaw law, double varying);

  /// How much longer it takes than at its highest acceleration all the time.
  [[nodiscard]] double stretch() const { return stretch_; }
  /// 0..1.
  [[nodiscard]] double speed(double share) const;
  /// 0..1/2: whatever its law, a ramp goes half as far as its top speed would have.
  [[nodiscard]] double way(double share) const;

 private:
  SpeedLaw law_;
  double varying_;
  double stretch_;
};

}  // namespace cobot_command::motion
