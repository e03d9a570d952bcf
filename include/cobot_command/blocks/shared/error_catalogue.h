// The catalogue of all ErrorIDs with texts and remedies (thesis tables 5.3.x; own ids from 16#200). It
// consists of the tables of all blocks.
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
/// nullptr: the block has no such id.
[[nodiscard]] const ErrorEntry* findError(Block block, int id);

// Common failures are identified by general ids. Some blocks report them under ids of their own.
/// The id under which the block reports the general `id`; `id` itself if the block has no id of its own for
/// it.
[[nodiscard]] int ownErrorId(Block block, int id);
/// The inverse. If several general ids have the same own id: the first in the block's list.
[[nodiscard]] int generalErrorId(Block block, int id);
/// True: an outcome of the block with `id` may be the error `general`.
[[nodiscard]] inline bool isError(Block block, int id, int general) {
  return id == ownErrorId(block, general);
}
/// True: `id` takes precedence over `other` if both are found. Either may be a general id.
[[nodiscard]] bool decidesBefore(Block block, int id, int other);

/// For people, in the notation of the source: 16#10 as in the thesis and in this layer, 1010 as in the manual
/// of path loading.
[[nodiscard]] std::string errorNumber(int id);

}  // namespace cobot_command::blocks
