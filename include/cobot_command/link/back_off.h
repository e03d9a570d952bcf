// The waits between tries: doubling from a minimum up to a maximum, until a try succeeds.
#pragma once

#include <algorithm>

#include "cobot_command/common/time.h"

namespace cobot_command::link {

class BackOff {
 public:
  BackOff(Duration minimum, Duration maximum) : minimum_(minimum), maximum_(maximum), next_(minimum) {}

  /// How long to wait before the next try.
  [[nodiscard]] Duration next() {
    const Duration wait = std::min(next_, maximum_);
    next_ = std::min(next_ * 2, maximum_);
    return wait;
  }
  void reset() { next_ = minimum_; }

 private:
  Duration minimum_;
  Duration maximum_;
  Duration next_;
};

}  // namespace cobot_command::link
