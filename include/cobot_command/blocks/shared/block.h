// A function block as a value: its place in the list of all blocks (Goal).
#pragma once

#include <cstddef>

namespace cobot_command::blocks {

enum class Block : std::size_t {};

[[nodiscard]] const char* toString(Block block);  ///< "connect", "move_absolute": the action's name

}  // namespace cobot_command::blocks
