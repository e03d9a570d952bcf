// A tag on its way through the queue.
#pragma once

#include <cstdint>

namespace cobot_command::simulator {

/// One QueueTag line that was executed; the same tag number may be queued again and again.
struct QueuedTag {
  std::uint64_t serial = 0;
  int tag = 0;
  bool reported = false;  ///< too early (a fault), and not once more
};

}  // namespace cobot_command::simulator
