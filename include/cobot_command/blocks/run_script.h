// The escape hatch: lines of script as they are. Queue tags stay the layer's business.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct RunScriptGoal {
  static constexpr const char* kName = "run_script";
  [[nodiscard]] static ErrorTable errors();

  std::string script;         ///< lines separated by CR LF or LF; printable, at most 4096 bytes, no QueueTag
  bool await_motion = false;  ///< Done when all its motions are; else when the controller accepted it
  double reply_timeout = 0;  ///< for the OK, longer for lines that wait [s], 0.05..3600; 0: as for all others
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const RunScriptGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RunScriptGoal& goal);
/// Without line ends, without empty lines, and without a ScriptExit() at the end: that is told by
/// GoalTraits::exits_node, as it has to come behind the queue tag.
[[nodiscard]] Order orderOf(const RunScriptGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
