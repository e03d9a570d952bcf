// Sets a digital output, or the analog output, of the controller: as a queued command, or at once, in
// parallel with the running command.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

enum class OutputKind : int { Digital = 0, Analog = 1 };

struct SetOutputGoal {
  static constexpr const char* kName = "set_output";
  [[nodiscard]] static ErrorTable errors();

  int kind = 0;          ///< OutputKind
  std::string module;    ///< "ControlBox" or "EndModule"; only the first has an analog output
  int output = 0;        ///< digital: 0..15 of the ControlBox, 0..3 of the EndModule; analog: 0
  double value = 0;      ///< digital: 0 or 1; analog: -10..10 [V]
  bool at_once = false;  ///< in parallel with the running command; buffer_mode then has no meaning
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const SetOutputGoal& goal);
[[nodiscard]] std::vector<Failure> check(const SetOutputGoal& goal);
[[nodiscard]] Order orderOf(const SetOutputGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
