// Stops the robot and empties its queue (StopAndClearBuffer), on a path of its own: never waits behind a
// command. Everything that is Busy or waits ends as CommandAborted. Done when the robot stands.
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
