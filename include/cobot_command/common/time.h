// Time in the core. The caller passes it in; the core never reads a clock.
#pragma once

#include <chrono>

namespace cobot_command {

/// The clock of the program that drives the core: real, scaled, or simulated by a test. The core never reads
/// it.
struct DriverClock {
  using rep = std::chrono::nanoseconds::rep;
  using period = std::chrono::nanoseconds::period;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<DriverClock>;
  static constexpr bool is_steady = true;  // NOLINT(readability-identifier-naming): std::chrono's name
};

using Duration = std::chrono::nanoseconds;
using Instant = DriverClock::time_point;

[[nodiscard]] constexpr double toSeconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// Rounds up to whole nanoseconds, so that a motion of this duration is really finished at its end.
[[nodiscard]] constexpr Duration fromSeconds(double seconds) {
  return std::chrono::ceil<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace cobot_command
