#include "monitor/track.h"

#include <algorithm>

namespace cobot_command::cell::monitor {
namespace {

constexpr Duration kMostAge = std::chrono::hours(1);
/// Of values measured closer to each other than this, the speed would be that of their last digits, and of
/// the network.
constexpr Duration kLeastApart = std::chrono::milliseconds(5);

Track::Axes atMost(Track::Axes speeds, const std::vector<double>& most) {
  for (Eigen::Index axis = 0; axis < speeds.size(); ++axis) {
    const auto index = static_cast<std::size_t>(axis);
    if (index < most.size()) speeds[axis] = std::min(speeds[axis], most[index]);
  }
  return speeds;
}

}  // namespace

Track::Taken Track::note(const Axes& values, const std::optional<Axes>& speeds, Duration age, Instant now,
                         Duration most) {
  if (age < Duration::zero() || age > kMostAge) return Taken::Malformed;
  const Instant measured = now - age;
  if (measured_ && measured <= *measured_) return Taken::Old;
  derive(values, measured, most);
  speeds_ = derived_;
  if (speeds) {
    // Some tell zeros whatever the arm does.
    speeds_ = speeds_.cwiseMax(speeds->cwiseAbs());
  }
  speeds_known_ = derived_known_ || speeds;
  measured_ = measured;
  values_ = values;
  place();
  return Taken::Yes;
}

void Track::derive(const Axes& values, Instant measured, Duration most) {
  const Duration apart = reference_ ? measured - reference_->measured : Duration::zero();
  if (reference_ && apart < kLeastApart) return;
  // What it did meanwhile says little of what it does now, when it was not heard for long.
  derived_known_ = reference_ && apart <= most;
  derived_.setZero(values.size());
  if (derived_known_) {
    derived_ = atMost((values - reference_->values).cwiseAbs() / toSeconds(apart), most_speeds_);
  }
  reference_ = Reference{measured, values};
}

void Track::grow(Duration age, const std::vector<double>& most_speeds) {
  growing_ = atMost(speeds_, most_speeds);
  set_.most_growth = 0;
  for (std::size_t i = 0; i < set_.capsules.size(); ++i) {
    set_.growth[i] = displacement(i, toSeconds(age));
    set_.most_growth = std::max(set_.most_growth, set_.growth[i]);
  }
}

Duration Track::age(Instant now) const {
  return std::max(Duration::zero(), now - *measured_);
}

bool Track::moves(double standing_speed) const {
  return heard() && (!speeds_known_ || speeds_.maxCoeff() > standing_speed);
}

}  // namespace cobot_command::cell::monitor
