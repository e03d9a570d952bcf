// The programs of the robots of a cell as far as other robots are concerned: the zones that they book and
// release on each path.
//
// Created from planned motions (cell/zones), or written by hand in tests. Mechanisms are included as robots.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// Indices into CellProgram::zones, ::robots and RobotProgram::paths.
using ZoneIndex = std::size_t;
using RobotIndex = std::size_t;
using PathIndex = std::size_t;

/// A booking or a release on a path, in order of occurrence. At the same place releases are before bookings.
struct ZoneStep {
  bool books = true;
  std::vector<ZoneIndex> zones;  ///< bookings: all of them at once or none; releases: one zone
  /// A booking that cannot be refused: the mechanism makes it automatically after its go.
  bool uncontrollable = false;
};

struct PathProgram {
  std::string name;
  std::size_t from = 0;  ///< station
  std::size_t to = 0;    ///< station
  std::vector<ZoneStep> steps;
  bool uncontrollable_go = false;  ///< a mechanism that starts automatically
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
