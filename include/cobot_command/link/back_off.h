// Waiting times between attempts. They double from a minimum up to a maximum, until an attempt succeeds.
#pragma once

#include <algorithm>

#include "cobot_command/common/time.h"

namespace cobot_command::link {

class BackOff {
 public:
  /// Waiting time before the next attempt.
  [[nodiscard]] Duration next(Duration minimum, Duration maximum) {
    const Duration wait = std::min(std::max(next_, minimum), maximum);
    next_ = wait * 2;
    return wait;
  }
  void reset() { next_ = {}; }

 private:
  Duration next_{};
};

}  // namespace cobot_command::link
