// What was found when everything under way was to end in its own time.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/finish_after.h"

namespace cobot_command::command {

/// Why what waits ends then.
inline constexpr const char* kNothingBehindFinish =
    "what is under way was to be finished, and nothing behind it";

struct FinishReport {
  /// Comes to its end in its own time, and its result tells which: also a stop, or a command that is being
  /// stopped already, which finish changes nothing of.
  std::optional<blocks::Block> under_way;
  int dropped = 0;        ///< goals that waited behind it, and have ended
  bool moves_on = false;  ///< what nobody waits for: blended motions, say, that are done for their goals

  /// There was something to finish.
  [[nodiscard]] bool foundAny() const { return under_way || dropped > 0; }
};
/// "move_absolute comes to its end; ...", or that there is nothing to finish.
[[nodiscard]] std::string toText(const FinishReport& report);

}  // namespace cobot_command::command
