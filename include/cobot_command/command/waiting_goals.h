// What holds for goals that wait, wherever they do: in the core for their turn, in front of it for a frame or
// a file.
#pragma once

#include <cstddef>
#include <functional>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::command {

/// In each of the places where they wait.
inline constexpr std::size_t kMostWaiting = 64;

/// 80 % of those that can wait, and of the one under way: time to send no more.
inline constexpr int kManyCommands = (static_cast<int>(kMostWaiting) + 1) * 4 / 5;

/// The newest goal that has come anywhere, also where goals wait before they are submitted. Goals count up
/// in the order in which they came.
using NewestGoal = std::function<blocks::GoalId()>;

/// Whether it ends with a command in front of it that fails or is cancelled. What begins nothing at the robot
/// does not, nor what halts it or makes its connection.
[[nodiscard]] bool fallsWithOthers(const blocks::Goal& goal);

/// Of a goal that comes when `waiting` goals wait already. Precondition: the goals of that block may wait
/// (fallsWithOthers()).
[[nodiscard]] blocks::Outcome refusedAsTooMany(blocks::Block block, std::size_t waiting);

}  // namespace cobot_command::command
