// Reduces the number of states without changing decisions: removes events that no other automaton has and
// that nothing can delay (doc/cell.md).
#pragma once

#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::automata {

struct Compressed {
  Problem problem;  ///< without the removed events
  /// [automaton][old local state]: the new state.
  std::vector<std::vector<StateIndex>> state_of;
  /// [new event]: the old event.
  std::vector<EventIndex> events;
};

/// Removes each event that only one plant has and that is the only event in every state where it is possible.
/// Its two states become one, which is marked if one of them was. The events in `kept` remain: events that
/// must be refused because of what follows them automatically.
///
/// Decisions on all other events do not change if each plant can continue to a marked state alone as soon as
/// no other plant holds anything that it needs. This is true for the model of a cell, because its programs
/// lead home.
[[nodiscard]] Compressed compress(const Problem& problem, const std::vector<EventIndex>& kept = {});

}  // namespace cobot_command::automata
