// A control problem: plants (the system) and specs (what is permitted), as automata over named events
// (doc/cell.md).
//
// An event happens if every automaton that has it in its alphabet has a transition for it. The reachable
// composition of all automata is K. A state of K is marked if all automata are in a marked state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cobot_command::automata {

/// Index into Problem::events.
using EventIndex = std::uint32_t;
/// Index into Automaton::states.
using StateIndex = std::uint32_t;

struct Event {
  std::string name;          ///< for display and for the canonical order; never parsed
  bool controllable = true;  ///< may be refused; an uncontrollable event only reports what happened
};

struct Transition {
  StateIndex from = 0;
  EventIndex event = 0;
  StateIndex to = 0;
};

struct Automaton {
  enum class Kind { Plant, Spec };

  std::string name;
  Kind kind = Kind::Plant;
  std::vector<EventIndex> alphabet;  ///< events that need it; one without any transition never happens
  std::vector<std::string> states;
  StateIndex initial = 0;
  std::vector<StateIndex> marked;  ///< where it may stay forever
  std::vector<Transition> transitions;
};

struct Problem {
  std::string name;
  std::string about;
  std::vector<Event> events;
  std::vector<Automaton> automata;
};

/// One sentence per fault: duplicate names, invalid indices, nondeterminism, an event without a plant, no
/// marked state. Empty: the problem can be composed.
[[nodiscard]] std::vector<std::string> faultsOf(const Problem& problem);

}  // namespace cobot_command::automata
