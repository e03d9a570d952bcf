// Targets in frames that have moved since they were looked up: a pallet that was pushed, or the robot itself
// on its vehicle.
//
// A goal goes where its frame was when the goal came. That is checked, and it is what the goals behind it
// are planned from. So a frame that has moved when the turn comes is an error with a name, and not another
// target.
#pragma once

#include <optional>

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/goal_values.h"

namespace cobot_command::blocks {

/// Why a goal with that target must not start; nothing when the target is where it was, when there is none in
/// a frame, or nobody can be asked. `field`: of the goal, as the caller knows it.
[[nodiscard]] std::optional<Failure> findMovedFrame(const char* field, const std::optional<FramedPose>& pose,
                                                    const FrameFinder& finder);

}  // namespace cobot_command::blocks
