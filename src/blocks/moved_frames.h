// Targets in frames that have moved since they were looked up: a pallet that was pushed, or the robot itself
// on its vehicle.
//
// A goal goes where its frame was when the goal came. That is checked, and it is what the goals behind it
// are planned from. So a frame that has moved when the turn comes is an error with a name, and not another
// target.
#pragma once

#include <optional>

#include "failure.h"

#include "cobot_command/blocks/frame_finder.h"
#include "cobot_command/blocks/goal.h"

namespace cobot_command::blocks {

/// Why a goal that has waited must not start; nothing when its targets are where they were, when it has none
/// in a frame, or nobody can be asked.
[[nodiscard]] std::optional<Outcome> refusalOfMovedFrame(const Goal& goal, const FrameFinder& finder);

/// The same for one move of a cycle.
[[nodiscard]] std::optional<Failure> findMovedFrame(const MoveAbsoluteGoal& goal, const FrameFinder& finder);

}  // namespace cobot_command::blocks
