// The present on the clock of all Instants of a node: steady, whatever is done to the clock of the wall.
#pragma once

#include <chrono>

#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] inline Instant steadyNow() {
  return Instant(std::chrono::steady_clock::now().time_since_epoch());
}

}  // namespace cobot_command::ros_adapter
