// Fewer states with the same decisions: what nobody else sees and nothing can hold up is left out (cell.md,
// M25).
#pragma once

#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::automata {

struct Compressed {
  Problem problem;  ///< without the events that are left out
  /// By automaton and old local state: the new one.
  std::vector<std::vector<StateIndex>> state_of;
  /// By new event: the old one.
  std::vector<EventIndex> events;
};

/// Leaves out each event that one plant alone has, and that is the only one wherever it can happen: its two
/// ends become one state, which is marked when one of them was. Those in `kept` stay: events that have to be
/// refused for what comes behind them by itself.
///
/// The decisions on all other events stay the same where each plant, once nothing that it needs is held by
/// others, can go on to a marked state alone: so it is in the model of a cell, as its programs lead home.
[[nodiscard]] Compressed compress(const Problem& problem, const std::vector<EventIndex>& kept = {});

}  // namespace cobot_command::automata
