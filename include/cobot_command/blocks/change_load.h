// The weight of the payload in the tool, for the motions that follow.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct ChangeLoadGoal {
  static constexpr const char* kName = "change_load";
  [[nodiscard]] static ErrorTable errors();

  double weight = 0;  ///< [kg], 0..14, without the tool
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const ChangeLoadGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ChangeLoadGoal& goal);
[[nodiscard]] Order orderOf(const ChangeLoadGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
