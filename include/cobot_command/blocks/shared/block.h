// Identifies a function block: its index in the list of all blocks (Goal).
#pragma once

#include <cstddef>

namespace cobot_command::blocks {

enum class Block : std::size_t {};

[[nodiscard]] const char* toString(Block block);  ///< the action's name: "connect", "move_absolute"

}  // namespace cobot_command::blocks
