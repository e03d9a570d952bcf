#include "drive/path_clock.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::simulator {

namespace {

double nanoseconds(Duration duration) {
  return static_cast<double>(duration.count());
}

Duration rounded(double nanoseconds) {
  return Duration(std::llround(nanoseconds));
}

}  // namespace

void PathClock::start(Instant now) {
  since_ = now;
  path_since_ = Duration::zero();
  rate_since_ = target_ = pace_ = 1.0;
  ramp_length_ = Duration::zero();
}

void PathClock::rebase(Instant now) {
  const Duration path_time = pathTime(now);
  const double share_now = share(now);
  ramp_length_ = std::max(settled() - now, Duration::zero());
  since_ = now;
  path_since_ = path_time;
  rate_since_ = ramp_length_ == Duration::zero() ? target_ : share_now;
}

void PathClock::setPace(Instant now, double pace) {
  rebase(now);
  pace_ = pace;
}

void PathClock::steer(Instant now, double target) {
  rebase(now);
  target_ = target;
  ramp_length_ = rounded(nanoseconds(ramp_) * std::abs(target - rate_since_));
  if (ramp_length_ == Duration::zero()) rate_since_ = target;
}

double PathClock::slope() const {
  return ramp_length_ == Duration::zero() ? 0.0 : (target_ - rate_since_) / nanoseconds(ramp_length_);
}

Duration PathClock::rampDistance() const {
  return rounded(0.5 * (rate_since_ + target_) * nanoseconds(ramp_length_));
}

Duration PathClock::pathTime(Instant at) const {
  const Duration way = sinceSteering(at);
  return path_since_ + (pace_ == 1.0 ? way : rounded(nanoseconds(way) * pace_));
}

Duration PathClock::sinceSteering(Instant at) const {
  const Duration elapsed = at - since_;
  if (elapsed < ramp_length_) {
    const double t = nanoseconds(elapsed);
    return rounded(t * (rate_since_ + 0.5 * slope() * t));
  }
  return rampDistance() + (target_ > 0.0 ? elapsed - ramp_length_ : Duration::zero());
}

double PathClock::rate(Instant at) const {
  return pace_ * share(at);
}

double PathClock::share(Instant at) const {
  const Duration elapsed = at - since_;
  return elapsed < ramp_length_ ? rate_since_ + slope() * nanoseconds(elapsed) : target_;
}

std::optional<Instant> PathClock::reaches(Duration path_time) const {
  const Duration way = std::max(path_time - path_since_, Duration::zero());
  const Duration remaining = pace_ == 1.0 ? way : rounded(std::ceil(nanoseconds(way) / pace_));
  const Duration ramp_distance = rampDistance();
  if (remaining > ramp_distance) {
    if (target_ <= 0.0) return std::nullopt;
    return settled() + (remaining - ramp_distance);
  }
  // The smaller root of rate t + slope t^2 / 2 = remaining, in the form that does not cancel.
  const double distance = nanoseconds(remaining);
  const double discriminant = std::max(0.0, rate_since_ * rate_since_ + 2.0 * slope() * distance);
  const double divisor = rate_since_ + std::sqrt(discriminant);
  if (divisor <= 0.0) return since_;
  const Duration elapsed(static_cast<Duration::rep>(std::ceil(2.0 * distance / divisor)));
  return since_ + std::min(elapsed, ramp_length_);
}

}  // namespace cobot_command::simulator
