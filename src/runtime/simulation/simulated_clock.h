// The clock of a simulated world: real time, scaled, and free to jump ahead. It never reads a clock itself.
#pragma once

#include <chrono>

#include "cobot_command/common/time.h"

namespace cobot_command::runtime {

class SimulatedClock {
 public:
  using RealTime = std::chrono::steady_clock::time_point;

  /// What a program may be held up (by a debugger, by the sleep of a laptop) without it counting as lived
  /// through: beyond that the simulated time stands still, so that nobody is flooded with what was missed.
  static constexpr Duration kLongestStep = std::chrono::seconds(1);
  /// How long to wait at most before the next step, so that waiting is never taken for being held up.
  static constexpr Duration kLongestWait = std::chrono::milliseconds(250);

  /// Starts at Instant{}. Precondition: scale > 0.
  SimulatedClock(double scale, RealTime start) : scale_(scale), real_(start) {}

  /// Goes on with real time, and tells the simulated one.
  Instant stepTo(RealTime real);
  /// Goes ahead to `instant`; an earlier one is ignored.
  void jumpTo(Instant instant);
  /// When to step so as not to miss `instant`: then, or kLongestWait after the last step.
  [[nodiscard]] RealTime realTimeOf(Instant instant) const;

 private:
  double scale_;
  RealTime real_;
  Instant now_{};
};

}  // namespace cobot_command::runtime
