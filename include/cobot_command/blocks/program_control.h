// CBT_ProgramControl (thesis 5.3.7): pause and resume. It never waits for a command and is never
// refused because of one.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

enum class ProgramCommand : int { Pause = 0, Resume = 1 };  ///< Table 5.3.7.4

struct ProgramControlGoal {
  static constexpr const char* kName = "program_control";
  [[nodiscard]] static ErrorTable errors();

  int command_id = 0;  ///< 0 or 2..9; only echoed
  int command = 0;     ///< ProgramCommand
};

[[nodiscard]] GoalTraits traitsOf(const ProgramControlGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ProgramControlGoal& goal);
[[nodiscard]] Order orderOf(const ProgramControlGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
