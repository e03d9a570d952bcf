// How paths are loaded and sent, whatever goal they are of.
#pragma once

#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"

namespace cobot_command::path {

struct PathSettings {
  int buffer = 5;  ///< places beside the active point, 1..15
  /// So long a path that ends with a blend waits for the next one before it comes to rest, 0..10 s.
  Duration chain_wait = std::chrono::milliseconds(200);
  Duration segment = motion::kLeastSegment;  ///< of a PVT at least: whole milliseconds, 25..100
  int block_points = 5000;                   ///< of one PVT at most, 100..6000
};

}  // namespace cobot_command::path
