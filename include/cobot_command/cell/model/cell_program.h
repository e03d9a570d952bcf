// What robots of a cell do, as far as the others have to know: which zones they book and release on which
// way.
//
// Made of planned motions (cell/zones), or written down by hand in tests. Mechanisms are robots here.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Into CellProgram::zones, ::robots and RobotProgram::paths.
using ZoneIndex = std::size_t;
using RobotIndex = std::size_t;
using PathIndex = std::size_t;

/// On a path, in the order in which they come; at the same place releases come before bookings.
struct ZoneStep {
  bool books = true;
  std::vector<ZoneIndex> zones;  ///< booked all at once, or not; one that is released
  /// A booking that cannot be refused: what the mechanism does once it was let go.
  bool uncontrollable = false;
};

struct PathProgram {
  std::string name;
  std::size_t from = 0;  ///< station
  std::size_t to = 0;    ///< station
  std::vector<ZoneStep> steps;
  bool uncontrollable_go = false;  ///< a mechanism that begins it by itself
};

struct RobotProgram {
  std::string name;
  std::vector<std::string> stations;
  std::size_t home = 0;
  std::vector<ZoneIndex> held_at_home;  ///< `holds: true`
  std::vector<PathProgram> paths;
};

struct CellProgram {
  std::string name;
  std::vector<std::string> zones;
  std::vector<RobotProgram> robots;
};

}  // namespace cobot_command::cell
