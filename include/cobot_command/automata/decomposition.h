// Problems of which no two share an event, made of one: each has a supervisor of its own (cell.md, M24).
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::automata {

struct PartOfProblem {
  Problem problem;
  std::vector<std::size_t> automata;  ///< by automaton of the part: that of the whole
  std::vector<EventIndex> events;     ///< by event of the part: that of the whole
};

/// By the first automaton of each. The product of non-blocking automata without common events is
/// non-blocking, so that their supervisors together are that of the whole.
[[nodiscard]] std::vector<PartOfProblem> independentParts(const Problem& problem);

}  // namespace cobot_command::automata
