// Rules for waiting goals, wherever they wait: in the core for their turn, or before the core for a frame or
// a file.
#pragma once

#include <cstddef>
#include <functional>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::command {

/// Maximum number in each place where goals wait.
inline constexpr std::size_t kMostWaiting = 64;

/// 80 % of the goals that can wait and run: clients should send no more.
inline constexpr int kManyCommands = (static_cast<int>(kMostWaiting) + 1) * 4 / 5;

/// The newest goal that was received anywhere, even if goals wait before they are submitted. Goal ids
/// increase in the order of reception.
using NewestGoal = std::function<blocks::GoalId()>;

/// True: the goal ends together with a preceding command that fails or is cancelled. False: it starts nothing
/// at the robot, it stops or pauses the robot, or it makes the connection.
[[nodiscard]] bool fallsWithOthers(const blocks::Goal& goal);

/// For a goal that arrives while `waiting` goals are already queued. Precondition: goals of that block can be
/// queued (fallsWithOthers()).
[[nodiscard]] blocks::Outcome refusedAsTooMany(blocks::Block block, std::size_t waiting);

}  // namespace cobot_command::command
