#include "trapezoid.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::motion {

// Lengths are measured in seconds at top speed, so the top speed is 1 and the acceleration 1 / ramp.
Trapezoid::Trapezoid(double travel, double ramp)
    : travel_(travel),
      ramp_(ramp),
      ramp_used_(std::min(ramp, std::sqrt(travel * ramp))),
      duration_(travel < kNoTravel ? 0.0 : 2.0 * ramp_used_ + (travel - ramp_used_ * (ramp_used_ / ramp))) {}

double Trapezoid::progress(double time) const {
  const double left = duration_ - time;
  if (time < ramp_used_) {
    return 0.5 * time * (time / ramp_) / travel_;
  }
  if (left < ramp_used_) {
    return 1.0 - 0.5 * left * (left / ramp_) / travel_;
  }
  return (time - 0.5 * ramp_used_) * (ramp_used_ / ramp_) / travel_;
}

double Trapezoid::rate(double time) const {
  return std::min({time, duration_ - time, ramp_used_}) / ramp_ / travel_;
}

}  // namespace cobot_command::motion
