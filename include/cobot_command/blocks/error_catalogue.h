// The one place with every ErrorID, its text and its remedy (thesis tables 5.3.x; own ids from 16#200).
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/blocks/goal.h"

namespace cobot_command::blocks {

enum class Block {
  Connect,
  MoveAbsolute,
  MoveRelative,
  MoveCircle,
  ChangeBase,
  ChangeTcp,
  ProgramControl,
  Stop,
  ExitListenNode,
  RunScript,
  CheckSequence,
  PickAndPlace
};
inline constexpr std::size_t kBlockCount = 12;
[[nodiscard]] const char* toString(Block block);  ///< "connect", "move_absolute": the action's name

/// The block of a goal: the alternatives of Goal stand in the order of Block.
[[nodiscard]] inline Block blockOf(const Goal& goal) {
  static_assert(std::variant_size_v<Goal> == kBlockCount);
  return static_cast<Block>(goal.index());
}

/// One row of a block's error table. The meaning of an id depends on the block.
struct ErrorEntry {
  Block block;
  int id;                   ///< hexadecimal in the thesis: 16#10 is 0x10
  const char* description;  ///< "Error Description" column
  const char* remedy;       ///< "Action" column
  const char* raised_when;  ///< when this layer raises it, or why it cannot occur any more
};

/// All rows, ordered by block and id.
[[nodiscard]] const std::vector<ErrorEntry>& errorCatalogue();
/// Nothing (nullptr) when the block has no such id.
[[nodiscard]] const ErrorEntry* findError(Block block, int id);

}  // namespace cobot_command::blocks
