// The synchronous composition of all automata of a problem: the possible events of a state, and their
// successor states.
//
// A state is the tuple of the local states. Immutable; safe to share between threads.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"

namespace cobot_command::automata {

/// The local state of each automaton, in the order of Problem::automata.
using Tuple = std::vector<StateIndex>;

class Composition {
 public:
  enum class Part { All, Plants };
  enum class Step {
    Possible,
    NotInPlants,  ///< a plant has no transition for it
    BlockedBySpec
  };

  /// Precondition: faultsOf(problem) is empty. With Part::Plants only the plants restrict the events.
  explicit Composition(const Problem& problem, Part part = Part::All);

  [[nodiscard]] std::size_t size() const { return state_counts_.size(); }
  [[nodiscard]] std::size_t events() const { return controllable_.size(); }
  [[nodiscard]] StateIndex stateCount(std::size_t automaton) const { return state_counts_[automaton]; }
  [[nodiscard]] const Tuple& initial() const { return initial_; }
  [[nodiscard]] bool isControllable(EventIndex event) const { return controllable_[event]; }
  [[nodiscard]] bool isMarked(const StateIndex* tuple) const;

  /// `to` differs from `from` only if the step is possible. Both may be the same array.
  Step step(const StateIndex* from, EventIndex event, StateIndex* to) const;
  /// The first automaton without a transition for it, plants before specs; std::nullopt if the event is
  /// possible.
  [[nodiscard]] std::optional<std::size_t> blockerOf(const StateIndex* from, EventIndex event) const;

  /// The events that may be possible in a state, unordered: those for which one of their plants has a
  /// transition.
  template <class Visitor>
  void forEachCandidate(const StateIndex* tuple, const Visitor& visit) const {
    for (std::size_t automaton = 0; automaton < candidates_.size(); ++automaton) {
      for (const EventIndex event : candidates_[automaton][tuple[automaton]]) visit(event);
    }
  }

 private:
  static constexpr StateIndex kNone = ~StateIndex{0};
  /// One automaton in one event: its next state, by local state.
  struct Participant {
    std::size_t automaton = 0;
    bool is_plant = true;
    std::vector<StateIndex> next;
  };

  void addStates(const Automaton& automaton, Part part);
  void addEvents(const Automaton& automaton, std::size_t index);
  void findCandidates();

  std::vector<std::vector<Participant>> participants_;            ///< by event, plants first
  std::vector<bool> controllable_;                                ///< by event
  std::vector<std::vector<std::vector<EventIndex>>> candidates_;  ///< by automaton and local state
  std::vector<StateIndex> state_counts_;
  std::vector<std::vector<bool>> marked_;
  Tuple initial_;
};

}  // namespace cobot_command::automata
