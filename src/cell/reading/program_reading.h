// Programs of robots: paths with their steps, as they stand in a cell file.
#pragma once

#include "checks/fault_list.h"

namespace cobot_command::cell {

/// How many steps all programs of a cell may have: aliases make long programs of short files.
inline constexpr std::size_t kMostStepsOfCell = 20000;
/// Of the program of a robot or of a mechanism.
inline constexpr std::size_t kMostPaths = 256;

struct ProgramReading {
  FaultList& faults;
  const std::vector<Part>& parts;
  const ReadFile& read_file;
  std::size_t steps = 0;  ///< of all programs so far
};

/// The program of a robot whose stations are known; `field`: "programs.RA". Faults are collected.
void readProgram(const YAML::Node& node, const std::string& field, Robot& robot, ProgramReading& reading);

}  // namespace cobot_command::cell
