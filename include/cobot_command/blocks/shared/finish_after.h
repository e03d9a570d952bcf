// How much of what is under way is still to be done when it is to end in its own time.
#pragma once

namespace cobot_command::blocks {

/// A cancel stops the robot at once; this lets it finish first, as a falling Execute does (thesis annex B).
enum class FinishAfter {
  Move,  ///< the move, or the output, that is under way; a wait for an input or a time ends at once
  Cycle  ///< the whole cycle of a pick and place
};

}  // namespace cobot_command::blocks
