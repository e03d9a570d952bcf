// The result of a request to end the running command without a stop.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/finish_after.h"

namespace cobot_command::command {

/// Reason for which queued goals then end.
inline constexpr const char* kNothingBehindFinish = "only the running command was to be finished";

struct FinishReport {
  /// The running block, which comes to its end; its result shows which end. It may also be a stop, or a
  /// command that is already being stopped: finish does not change those.
  std::optional<blocks::Block> under_way;
  int dropped = 0;  ///< queued goals that have ended
  /// Motions that no goal waits for any more, for example blended ones, which are done for their goals.
  bool moves_on = false;

  /// True: there was something to finish.
  [[nodiscard]] bool foundAny() const { return under_way || dropped > 0; }
};
/// "move_absolute comes to its end; ...", or that there is nothing to finish.
[[nodiscard]] std::string toText(const FinishReport& report);

}  // namespace cobot_command::command
