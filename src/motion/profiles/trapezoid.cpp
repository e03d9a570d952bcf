#include "profiles/trapezoid.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::motion {

// Lengths are measured in seconds at top speed, so the top speed is 1 and the acceleration 1 / ramp.
Trapezoid::Trapezoid(double travel, double ramp, double start_share)
    : travel_(travel),
      ramp_(start_share > 0.0 ? std::min(ramp, 2.0 * travel / (start_share * start_share)) : ramp),
      start_share_(start_share) {
  const double head_start = start_share_ * ramp_;  // the time to the speed that it begins with
  down_ = std::min(ramp_, std::sqrt(travel_ * ramp_ + 0.5 * head_start * head_start));
  up_ = std::max(0.0, down_ - head_start);
  const double ramps = down_ * (down_ / ramp_) - 0.5 * head_start * start_share_;
  duration_ = travel_ < kNoTravel ? 0.0 : up_ + down_ + std::max(0.0, travel_ - ramps) * (ramp_ / down_);
}

Trapezoid Trapezoid::steady(double duration) {
  Trapezoid profile(duration, duration, 1.0);
  profile.up_ = profile.down_ = 0.0;
  profile.duration_ = duration;
  return profile;
}

double Trapezoid::progress(double time) const {
  const double left = duration_ - time;
  if (time < up_) {
    return time * (start_share_ + 0.5 * (time / ramp_)) / travel_;
  }
  if (left < down_) {
    return 1.0 - 0.5 * left * (left / ramp_) / travel_;
  }
  const double way_up = up_ * (start_share_ + 0.5 * (up_ / ramp_));
  const double top = down_ > 0.0 ? down_ / ramp_ : 1.0;
  return (way_up + (time - up_) * top) / travel_;
}

double Trapezoid::rate(double time) const {
  if (down_ == 0.0) {
    return 1.0 / travel_;
  }
  return std::min({start_share_ * ramp_ + time, duration_ - time, down_}) / ramp_ / travel_;
}

double Trapezoid::usableShare(double time, double excess) const {
  // A lower top speed slows the cruise in proportion, the ramps with its square root; whichever is slower at
  // this point counts.
  return std::max(shareOfTopSpeed(time) / excess, 1.0 / (excess * excess));
}

double Trapezoid::timeBeforeBraking(double progress) const {
  const double way = progress * travel_;
  const double way_up = up_ * (start_share_ + 0.5 * (up_ / ramp_));
  if (way < way_up) {
    return 2.0 * way / (start_share_ + std::sqrt(start_share_ * start_share_ + 2.0 * way / ramp_));
  }
  const double top = down_ > 0.0 ? down_ / ramp_ : 1.0;
  return std::min(up_ + (way - way_up) / top, duration_ - down_);
}

}  // namespace cobot_command::motion
