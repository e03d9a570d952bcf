// Canonical form of automata: identical for automata that differ only in the numbers and names of their
// states (doc/cell.md).
#pragma once

#include <string>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/synthesis.h"

namespace cobot_command::automata {

struct CanonicalForm {
  /// States are numbered breadth first from the initial state; the events of a state are in byte order of
  /// their names. Unreachable states have no number.
  std::vector<Transition> transitions;
  std::vector<StateIndex> marked;  ///< ascending
  std::size_t states = 0;

  /// SHA-256, hexadecimal, of the lines "FROM EVENT TO" and a last line "marked N N ...".
  [[nodiscard]] std::string fingerprint(const std::vector<Event>& events) const;
};

/// Precondition: all states and events exist, and the automaton is deterministic.
[[nodiscard]] CanonicalForm canonicalFormOf(const Automaton& automaton, const std::vector<Event>& events);

/// The supervisor as one automaton over all events. The names of its states are the names of the tuple,
/// joined by "|".
[[nodiscard]] Automaton automatonOf(const Synthesis& synthesis, const Problem& problem);

}  // namespace cobot_command::automata
