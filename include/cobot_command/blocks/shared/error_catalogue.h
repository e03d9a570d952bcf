// The one place with every ErrorID, its text and its remedy (thesis tables 5.3.x; own ids from 16#200): the
// tables of all blocks.
#pragma once

#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/error_table.h"

namespace cobot_command::blocks {

struct ErrorEntry : ErrorRow {
  Block block;
};

/// All rows, ordered by block and id.
[[nodiscard]] const std::vector<ErrorEntry>& errorCatalogue();
/// Nothing (nullptr) when the block has no such id.
[[nodiscard]] const ErrorEntry* findError(Block block, int id);

}  // namespace cobot_command::blocks
