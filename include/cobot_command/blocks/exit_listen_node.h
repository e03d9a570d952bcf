// Leaves the Listen node (ScriptExit) after all commands sent before are done.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct ExitListenNodeGoal {
  static constexpr const char* kName = "exit_listen_node";
  [[nodiscard]] static ErrorTable errors();

  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const ExitListenNodeGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ExitListenNodeGoal& goal);
[[nodiscard]] Order orderOf(const ExitListenNodeGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
