// A queued wait until a digital input of the controller has a value, according to the status stream. Nothing
// is sent.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

struct WaitForInputGoal {
  static constexpr const char* kName = "wait_for_input";
  [[nodiscard]] static ErrorTable errors();

  std::string module;  ///< "ControlBox" or "EndModule"
  int input = 0;       ///< 0..15 of the ControlBox, 0..3 of the EndModule
  bool value = false;  ///< the value to wait for
  double timeout = 0;  ///< from its turn on, without the time of pauses [s], 0..86400; 0: no timeout
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const WaitForInputGoal& goal);
[[nodiscard]] std::vector<Failure> check(const WaitForInputGoal& goal);
[[nodiscard]] std::unique_ptr<Run> runOf(const WaitForInputGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
