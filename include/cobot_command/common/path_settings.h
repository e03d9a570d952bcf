// How paths are taken, loaded and sent, whatever goal they are of.
#pragma once

#include <chrono>

#include "cobot_command/common/time.h"

namespace cobot_command {

/// What an operator sets of load_path; the setter of parameters checks the ranges.
struct PathSettings {
  /// Goals are taken while the status stream shows the manual mode.
  bool in_manual_mode = false;
  int buffer = 5;  ///< places beside the active point, 1..14
  /// So long a path that ends with a blend waits for the next one before it comes to rest, 0..10 s.
  Duration chain_wait = std::chrono::milliseconds(200);
  Duration segment = std::chrono::milliseconds(25);  ///< of a PVT at least: whole milliseconds, 25..100
  int block_points = 5000;                           ///< of one PVT at most, 100..6000
};

}  // namespace cobot_command
