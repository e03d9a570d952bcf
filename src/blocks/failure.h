// Why a command is refused or fails, before it becomes an Outcome.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/blocks/outcome.h"

namespace cobot_command::blocks {

/// A catalogue id and what was found. `remedy`: where the catalogue's own does not fit the finding.
struct Failure {
  int error_id = 0;
  std::string found;
  std::string remedy;
};

/// What ends everything that is under way (16#99).
[[nodiscard]] Failure emergencyStop();

/// So many wait that one more is refused (16#216).
[[nodiscard]] Failure tooManyWait(std::size_t waiting);

/// Rejected or Aborted, with the catalogue's texts.
/// Precondition: the block's catalogue has the id.
[[nodiscard]] Outcome toOutcome(Block block, Ending ending, const Failure& failure);

/// The first failure decides the id; the description lists the others. Precondition: not empty.
[[nodiscard]] Outcome toRejection(Block block, const std::vector<Failure>& failures);

}  // namespace cobot_command::blocks
