// Why a command is refused or fails, before it becomes an Outcome.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::blocks {

/// The step of a sequence or a cycle that is to blame.
struct StepBlame {
  int step = -1;                  ///< from 0; -1: none
  int error_id = 0;               ///< of the step's own block; 0: what is wrong has no error there
  std::string error_description;  ///< of that error, with its remedy
};

/// A catalogue id and what was found. `remedy`: where the catalogue's own does not fit the finding.
struct Failure {
  int error_id = 0;
  std::string found;
  std::string remedy;
  StepBlame blame{};
};

/// 16#251: the step `step` (from 0) of `count` cannot be made, for the reason `own`, that of its own block.
[[nodiscard]] Failure stepRefused(std::size_t step, std::size_t count, const Outcome& own);

/// Of a number of steps that may not be (16#250).
[[nodiscard]] std::string foundSteps(std::size_t count, std::size_t most);

/// So many wait that one more is refused (16#216).
[[nodiscard]] Failure tooManyWait(std::size_t waiting);

/// Rejected or Aborted, with the catalogue's texts, and with the step that is to blame.
/// Precondition: the block's catalogue has the id.
[[nodiscard]] Outcome toOutcome(Block block, Ending ending, const Failure& failure);

/// The failure that became that outcome of the block; for who passes it on under its own name. Precondition:
/// as for toOutcome().
[[nodiscard]] Failure failureOf(Block block, const Outcome& outcome);

/// As the tables of the blocks have them; those of one id keep their order.
void sortByTable(std::vector<Failure>& failures);

/// The first failure decides the id; the description lists the others. Precondition: not empty.
[[nodiscard]] Outcome toRejection(Block block, const std::vector<Failure>& failures);

/// Taken away by a cancel, or by another command; `why`: for people.
[[nodiscard]] Outcome commandAborted(std::string why);

}  // namespace cobot_command::blocks
