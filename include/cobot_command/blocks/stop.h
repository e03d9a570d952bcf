// Stops the robot and empties its queue (StopAndClearBuffer). It never waits for a command. All running and
// queued commands end as CommandAborted. Done when the robot is at standstill.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct StopGoal {
  static constexpr const char* kName = "stop";
  [[nodiscard]] static ErrorTable errors();
};

[[nodiscard]] GoalTraits traitsOf(const StopGoal& goal);
[[nodiscard]] std::vector<Failure> check(const StopGoal& goal);

}  // namespace cobot_command::blocks
