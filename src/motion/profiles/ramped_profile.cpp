#include "profiles/ramped_profile.h"

#include <algorithm>
#include <cmath>

namespace cobot_command::motion {
namespace {

/// A number of milliseconds that rounding alone has made longer is not rounded up once more.
constexpr double kSameMillisecond = 1e-6;

double wholeMilliseconds(double seconds) {
  return std::ceil(1e3 * seconds - kSameMillisecond) * 1e-3;
}

}  // namespace

Phases phasesOf(double way, const Rates& rates, const RampShape& shape) {
  const double up = Ramp(shape.law, shape.up).stretch() / rates.acceleration;
  const double down = Ramp(shape.law, shape.down).stretch() / rates.deceleration;
  const double highest = std::sqrt(2.0 * way / (up + down));
  if (highest <= rates.speed) return {up * highest, 0.0, down * highest};
  const double cruise = way / rates.speed - 0.5 * rates.speed * (up + down);
  if (cruise >= kShortestPhase) return {up * rates.speed, cruise, down * rates.speed};
  // As slow as it takes to cruise so long; next to a triangle that costs next to no time.
  const double half = kShortestPhase / (up + down);
  const double speed = way / (std::sqrt(half * half + highest * highest) + half) * 2.0 / (up + down);
  return {up * speed, kShortestPhase, down * speed};
}

Phases onGrid(const Phases& phases) {
  return {std::max(wholeMilliseconds(phases.up), kShortestPhase), wholeMilliseconds(phases.cruise),
          std::max(wholeMilliseconds(phases.down), kShortestPhase)};
}

double RampedProfile::progress(double time) const {
  const double left = duration() - time;
  if (time < phases_.up) return phases_.up * up_.way(time / phases_.up) / travel();
  if (left < phases_.down) return 1.0 - phases_.down * down_.way(left / phases_.down) / travel();
  return (time - 0.5 * phases_.up) / travel();
}

double RampedProfile::rate(double time) const {
  const double left = duration() - time;
  if (time < phases_.up) return up_.speed(time / phases_.up) / travel();
  if (left < phases_.down) return down_.speed(left / phases_.down) / travel();
  return 1.0 / travel();
}

}  // namespace cobot_command::motion
