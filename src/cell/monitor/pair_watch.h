// What is remembered of one pair: how close it was, and the breach that lasts.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "monitor/body_set.h"

#include "cobot_command/cell/monitor/monitor_state.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell::monitor {

/// Names of two things, or of their bodies.
struct Names {
  std::string first;
  std::string second;
};

/// A limit that is passed downwards at once, and upwards only with some more than it: a pair that stands at
/// the limit does not pass it each time its data changes in the last digit.
class Threshold {
 public:
  enum class Passed { None, Down, Up };

  Passed see(double value, double limit);
  [[nodiscard]] bool isBelow() const { return below_; }

 private:
  bool below_ = false;
};

struct PairWatch {
  std::size_t first = 0;   ///< a robot or mechanism
  std::size_t second = 0;  ///< another one, or behind all of those an obstacle
  bool known = false;
  Gap gap;
  Names bodies;  ///< of the gap; empty where that is not exact

  double least = std::numeric_limits<double>::infinity();  ///< [m]
  Instant least_at;
  Names least_bodies;

  Threshold stop;
  Threshold margin;
  std::optional<Breach> breach;  ///< that lasts

  /// Keeps the least distance.
  void keepLeast(Instant now);
  /// Goes on with the breach.
  void keepBreach(Instant now);
};

}  // namespace cobot_command::cell::monitor
