// One form for all automata that differ only in the numbers and names of their states (cell.md, M21).
#pragma once

#include <string>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/synthesis.h"

namespace cobot_command::automata {

struct CanonicalForm {
  /// By number: breadth first from the initial state, the events of a state in byte order of their names.
  /// What is not reached has none.
  std::vector<Transition> transitions;
  std::vector<StateIndex> marked;  ///< ascending
  std::size_t states = 0;

  /// SHA-256, hexadecimal, of the lines "FROM EVENT TO" and of a last one "marked N N ...".
  [[nodiscard]] std::string fingerprint(const std::vector<Event>& events) const;
};

/// Precondition: its states and events exist, and it is deterministic.
[[nodiscard]] CanonicalForm canonicalFormOf(const Automaton& automaton, const std::vector<Event>& events);

/// The supervisor as one automaton over all events; its states have the names of the tuple, joined by "|".
[[nodiscard]] Automaton automatonOf(const Synthesis& synthesis, const Problem& problem);

}  // namespace cobot_command::automata
