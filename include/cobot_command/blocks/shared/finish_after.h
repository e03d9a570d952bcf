// How much of the running command is completed before it ends without a stop.
#pragma once

namespace cobot_command::blocks {

/// A cancel stops the robot at once. This lets it finish first, like a falling Execute (thesis annex B).
enum class FinishAfter {
  Move,  ///< the running move or output; a wait for an input or a time ends at once
  Cycle  ///< the whole cycle of pick_and_place or run_program
};

}  // namespace cobot_command::blocks
