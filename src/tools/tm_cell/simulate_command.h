// The command that runs a whole cell in invented time.
#pragma once

#include <cstdint>
#include <string>

#include "answer.h"

#include "cobot_command/cell/model/supervisors.h"

namespace cobot_command::tools {

struct SimulateOptions {
  std::string artifact;
  std::string policy = "supervisor";  ///< of a cell::Policy, or "schedule"
  int cycles = 3;
  std::uint64_t seed = 1;
  bool is_random = false;
  double loss = 0.0;      ///< of the messages [%]
  bool is_quiet = false;  ///< without what happened, event by event
};

/// A fault, where not all robots have done their cycles, or two came closer than the cell's margin.
[[nodiscard]] Answer simulateCell(const SimulateOptions& options);

}  // namespace cobot_command::tools
