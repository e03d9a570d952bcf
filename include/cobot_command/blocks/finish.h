// How much of what is under way is still to be done when it is to end in its own time.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/blocks/error_catalogue.h"

namespace cobot_command::blocks {

/// A cancel stops the robot at once; this lets it finish first, as a falling Execute does (thesis annex B).
enum class FinishAfter {
  Move,  ///< the move, or the output, that is under way
  Cycle  ///< the whole cycle of a pick and place
};

/// Why what waits ends then.
inline constexpr const char* kNothingBehindFinish =
    "what is under way was to be finished, and nothing behind it";

/// What was found when everything was to be finished.
struct FinishReport {
  /// Comes to its end in its own time, and its result tells which: also a stop, or a command that is being
  /// stopped already, which finish changes nothing of.
  std::optional<Block> under_way;
  int dropped = 0;        ///< goals that waited behind it, and have ended
  bool moves_on = false;  ///< what nobody waits for: blended motions, say, that are done for their goals

  /// There was something to finish.
  [[nodiscard]] bool foundAny() const { return under_way || dropped > 0; }
};
/// "move_absolute comes to its end; ...", or that there is nothing to finish.
[[nodiscard]] std::string toText(const FinishReport& report);

}  // namespace cobot_command::blocks
