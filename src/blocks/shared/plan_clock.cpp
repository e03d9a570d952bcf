#include "shared/plan_clock.h"

#include <utility>

namespace cobot_command::blocks {

void PlanClock::hold(Instant now) {
  if (!held_since_) held_since_ = now;
}

bool PlanClock::letGo(Instant now) {
  if (!held_since_) return false;
  began_ += now - *std::exchange(held_since_, std::nullopt);
  return true;
}

Duration PlanClock::time(Instant now) const {
  return fromSeconds(toSeconds(held_since_.value_or(now) - began_) * rate_);
}

Duration PlanClock::byController(Duration planned) const {
  return fromSeconds(toSeconds(planned) / rate_);
}

}  // namespace cobot_command::blocks
