// Divides a problem into problems without common events. Each has its own supervisor (doc/cell.md).
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::automata {

struct PartOfProblem {
  Problem problem;
  std::vector<std::size_t> automata;  ///< by automaton of the part: its index in the whole problem
  std::vector<EventIndex> events;     ///< by event of the part: its index in the whole problem
};

/// Ordered by the first automaton of each part. The product of non-blocking automata without common events is
/// non-blocking, so the supervisors of the parts together are the supervisor of the whole.
[[nodiscard]] std::vector<PartOfProblem> independentParts(const Problem& problem);

}  // namespace cobot_command::automata
