// The waits between tries: doubling from a minimum up to a maximum, until a try succeeds.
#pragma once

#include <algorithm>

#include "cobot_command/common/time.h"

namespace cobot_command::link {

class BackOff {
 public:
  /// How long to wait before the next try.
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
