// The one place with every ErrorID, its text and its remedy (thesis tables 5.3.x; own ids from 16#200): the
// tables of all blocks.
#pragma once

#include <string>
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

// Common failures are named by their general ids, and told by some blocks under own numbers.
/// Under which id the block tells of it; `id` itself where it has no number of its own for it.
[[nodiscard]] int ownErrorId(Block block, int id);
/// The contrary; of several the first in the block's list.
[[nodiscard]] int generalErrorId(Block block, int id);
/// Whether an outcome of the block with `id` may be that general error.
[[nodiscard]] inline bool isError(Block block, int id, int general) {
  return id == ownErrorId(block, general);
}
/// Whether the first decides where both are found. Either may be general.
[[nodiscard]] bool decidesBefore(Block block, int id, int other);

/// For people, as the book has it from which the number is: 16#10, of the thesis and of this layer; 1010, of
/// the manual of path loading.
[[nodiscard]] std::string errorNumber(int id);

}  // namespace cobot_command::blocks
