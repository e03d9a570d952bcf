#include "monitor/mechanism_track.h"

#include <cmath>

namespace cobot_command::cell::monitor {
namespace {

/// No track is longer, and no turntable counts more turns [m or rad].
constexpr double kMostPosition = 1000;

}  // namespace

Track::Taken MechanismTrack::take(double position, Duration age, Instant now, Duration most) {
  if (!std::isfinite(position) || std::abs(position) > kMostPosition) return Taken::Malformed;
  return note(Axes::Constant(1, position), std::nullopt, age, now, most);
}

void MechanismTrack::place() {
  BodySet& set = bodies();
  set.capsules = mechanism_.at(values()[0]);
  set.fixed.assign(set.capsules.size(), 0);
  set.standStill();
  set.encloseAll();
}

double MechanismTrack::displacement(std::size_t body, double seconds) const {
  return mechanism_.displacementBound(body, speed(0) * seconds);
}

}  // namespace cobot_command::cell::monitor
