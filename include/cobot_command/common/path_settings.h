// Settings of path execution, for all kinds of goals: when paths are accepted, and how they are buffered and
// sent.
#pragma once

#include <chrono>

#include "cobot_command/common/time.h"

namespace cobot_command {

/// What an operator sets for load_path. The parameter setter checks the ranges.
struct PathSettings {
  /// Goals are also accepted while the status stream reports the manual mode.
  bool in_manual_mode = false;
  int buffer = 5;  ///< queued points in addition to the active one, 1..14
  /// How long a path that ends with a blend waits for the next path before it is sent with a stop at its end,
  /// 0..10 s.
  Duration chain_wait = std::chrono::milliseconds(200);
  Duration segment = std::chrono::milliseconds(25);  ///< shortest PVT segment: whole milliseconds, 25..100
  int block_points = 5000;                           ///< most points of one PVT, 100..6000
};

}  // namespace cobot_command
