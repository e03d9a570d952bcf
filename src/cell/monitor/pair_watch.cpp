#include "monitor/pair_watch.h"

namespace cobot_command::cell::monitor {

Threshold::Passed Threshold::see(double value, double limit) {
  constexpr double kMore = 0.001;  // [m]
  const bool was_below = below_;
  below_ = value < (was_below ? limit + kMore : limit);
  if (below_ == was_below) return Passed::None;
  return below_ ? Passed::Down : Passed::Up;
}

void PairWatch::keepLeast(Instant now) {
  least = gap.distance;
  least_at = now;
  least_bodies = bodies;
}

void PairWatch::keepBreach(Instant now) {
  if (gap.lowest >= breach->least) return;
  breach->least = gap.lowest;
  breach->distance = gap.distance;
  breach->least_at = now;
  breach->first_body = bodies.first;
  breach->second_body = bodies.second;
}

}  // namespace cobot_command::cell::monitor
