// What is to be controlled, and what is allowed of it: plants and specs, automata over named events (cell.md,
// section 5).
//
// An event happens when every automaton that has it in its alphabet can make it. All of them together, as far
// as it is reached, is K; K is marked where all automata are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cobot_command::automata {

/// Into Problem::events.
using EventIndex = std::uint32_t;
/// Into Automaton::states.
using StateIndex = std::uint32_t;

struct Event {
  std::string name;          ///< for people and for the canonical order; nothing is read out of it
  bool controllable = true;  ///< may be refused; one that is not only tells what happened
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
  std::vector<EventIndex> alphabet;  ///< events that need it; one without a transition anywhere never happens
  std::vector<std::string> states;
  StateIndex initial = 0;
  std::vector<StateIndex> marked;  ///< where it may rest for good
  std::vector<Transition> transitions;
};

struct Problem {
  std::string name;
  std::string about;
  std::vector<Event> events;
  std::vector<Automaton> automata;
};

/// Each a sentence: doubled names, indices of nothing, nondeterminism, an event of no plant, no marked state.
/// None: it can be composed.
[[nodiscard]] std::vector<std::string> faultsOf(const Problem& problem);

}  // namespace cobot_command::automata
