// A queued wait for a time (SRCI: WaitTime). Nothing is sent for the time itself.
#pragma once

#include <memory>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

struct WaitTimeGoal {
  static constexpr const char* kName = "wait_time";
  [[nodiscard]] static ErrorTable errors();

  double time = 0;  ///< from its turn on, without the time of pauses [s], 0..86400
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const WaitTimeGoal& goal);
[[nodiscard]] std::vector<Failure> check(const WaitTimeGoal& goal);
[[nodiscard]] std::unique_ptr<Run> runOf(const WaitTimeGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
