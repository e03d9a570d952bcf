// Raw script lines, for what no other block offers. They are sent unchanged. Only this layer inserts queue
// tags.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct RunScriptGoal {
  static constexpr const char* kName = "run_script";
  [[nodiscard]] static ErrorTable errors();

  std::string script;  ///< lines separated by CR LF or LF; printable, at most 4096 bytes, no QueueTag
  /// true: Done when all its motions are done; false: Done when the controller has accepted it.
  bool await_motion = false;
  /// Timeout for the OK, longer for lines that wait [s], 0.05..3600; 0: as for all other scripts.
  double reply_timeout = 0;
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const RunScriptGoal& goal);
[[nodiscard]] std::vector<Failure> check(const RunScriptGoal& goal);
/// The lines without line ends, without empty lines, and without a ScriptExit() at the end.
/// GoalTraits::exits_node indicates this exit, because it must follow the queue tag.
[[nodiscard]] Order orderOf(const RunScriptGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
