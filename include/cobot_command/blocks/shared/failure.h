// Why a command is refused or fails, before it becomes an Outcome.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/detail.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::blocks {

/// A catalogue id and what was found. `remedy`: where the catalogue's own does not fit the finding.
struct Failure {
  int error_id = 0;
  std::string found;
  std::string remedy;
  Detail detail{};                           ///< becomes that of the Outcome
  std::vector<std::string> refused_lines{};  ///< become those of the Outcome
};

/// So many wait that one more is refused (16#216).
[[nodiscard]] Failure tooManyWait(std::size_t waiting);

/// Rejected or Aborted, with the catalogue's texts, and with the failure's detail; under the block's own
/// number where it has one for that failure. Precondition: the block's catalogue has the id.
[[nodiscard]] Outcome toOutcome(Block block, Ending ending, const Failure& failure);

/// The failure that became that outcome of the block, under its general id and without its detail; for who
/// passes it on under its own name. Precondition: as for toOutcome().
[[nodiscard]] Failure failureOf(Block block, const Outcome& outcome);

/// As they decide in that block: mostly by id. Those of one id keep their order.
void sortByTable(Block block, std::vector<Failure>& failures);

/// The first failure decides the id; the description lists the others. Precondition: not empty.
[[nodiscard]] Outcome toRejection(Block block, const std::vector<Failure>& failures);

/// Taken away by a cancel, or by another command; `why`: for people.
[[nodiscard]] Outcome commandAborted(std::string why);

}  // namespace cobot_command::blocks
