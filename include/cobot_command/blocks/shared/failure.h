// Why a command is refused or fails, before this becomes an Outcome.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::blocks {

/// An id of the catalogue, and what was found. `remedy`: replaces that of the catalogue, if that does not
/// fit.
struct Failure {
  int error_id = 0;
  std::string found;
  std::string remedy;
  Detail detail{};                           ///< becomes the detail of the Outcome
  std::vector<std::string> refused_lines{};  ///< become the refused lines of the Outcome
};

/// 16#216: `waiting` goals are queued, and one more is refused.
[[nodiscard]] Failure tooManyWait(std::size_t waiting);

/// Rejected or Aborted, with the texts of the catalogue and the detail of the failure, under the block's own
/// number if it has one. Precondition: the block's catalogue has the id.
[[nodiscard]] Outcome toOutcome(Block block, Ending ending, const Failure& failure);

/// The failure that became this outcome of the block, under its general id and without its detail. A caller
/// can then report it under its own name. Precondition: as for toOutcome().
[[nodiscard]] Failure failureOf(Block block, const Outcome& outcome);

/// Sorts by precedence in that block, mostly by id. Failures with the same id keep their order.
void sortByTable(Block block, std::vector<Failure>& failures);

/// The first failure gives the id; the description lists the others. Precondition: not empty.
[[nodiscard]] Outcome toRejection(Block block, const std::vector<Failure>& failures);

/// Ended by a cancel or by another command; `why`: for people.
[[nodiscard]] Outcome commandAborted(std::string why);

}  // namespace cobot_command::blocks
