#include "simulation/simulated_clock.h"

#include <algorithm>

namespace cobot_command::runtime {

Instant SimulatedClock::stepTo(RealTime real) {
  const Duration step = std::clamp<Duration>(real - real_, Duration::zero(), kLongestStep);
  real_ = std::max(real, real_);
  now_ += fromSeconds(toSeconds(step) * scale_);
  return now_;
}

void SimulatedClock::jumpTo(Instant instant) {
  now_ = std::max(now_, instant);
}

SimulatedClock::RealTime SimulatedClock::realTimeOf(Instant instant) const {
  const double wait = std::max(0.0, toSeconds(instant - now_) / scale_);
  return real_ + (wait < toSeconds(kLongestWait) ? fromSeconds(wait) : kLongestWait);
}

}  // namespace cobot_command::runtime
