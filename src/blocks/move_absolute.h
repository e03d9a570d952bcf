// CBT_MoveAbsolute (thesis 5.3.2): what its goal must satisfy, and the script and the motion that it asks
// for.
//
// How a command lives on the wire is the same for all motions and not told here: motion_run.h.
#pragma once

#include <optional>
#include <vector>

#include "failure.h"

#include "cobot_command/blocks/goal.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::blocks {

/// All violations of the goal's own parameters, in table order; empty when it may be sent.
[[nodiscard]] std::vector<Failure> checkMoveAbsolute(const MoveAbsoluteGoal& goal);

/// PTP or Line, QueueTag when there is a tag, ScriptExit when asked for (function-blocks section 4). The
/// controller takes whole numbers for speed, time and blending: they are rounded to the nearest, the speed to
/// 1 at least. Precondition: checkMoveAbsolute() found nothing.
[[nodiscard]] std::vector<protocol::ScriptCommand> scriptOf(const MoveAbsoluteGoal& goal,
                                                            std::optional<int> tag);

/// The same motion in SI, for planning. Precondition as above.
[[nodiscard]] motion::Command motionOf(const MoveAbsoluteGoal& goal);

}  // namespace cobot_command::blocks
