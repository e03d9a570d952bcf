// The supervisor: the largest part of what can be reached that is allowed, can be held, and always leads
// home.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/automata/state_space.h"

namespace cobot_command::automata {

struct SynthesisCounts {
  std::size_t states = 0;
  std::size_t transitions = 0;
  std::size_t marked = 0;
  std::size_t refused_by_spec = 0;  ///< pairs of a state and a controllable event that a spec blocks there
  std::size_t refused_beyond_spec = 0;  ///< and of one that only the supervisor refuses
  std::size_t frontier = 0;             ///< states that only the supervisor keeps it from entering
};

/// Of a state space that has to live longer.
class Synthesis {
 public:
  using Number = StateSpace::Number;

  /// Takes away states that break a spec, those that an uncontrollable event leads to such from, and those
  /// from which no marked state is reached, until none are left of either; then what is not reached any more.
  explicit Synthesis(const StateSpace& space);

  /// Nothing is left: not even the initial state can be held.
  [[nodiscard]] bool empty() const { return !contains_[0]; }
  [[nodiscard]] bool contains(Number state) const { return contains_[state]; }
  /// States outside of it that a controllable event would lead to from inside, ascending. To keep out of them
  /// is all that a supervisor has to do beside the specs.
  [[nodiscard]] const std::vector<Number>& frontier() const { return frontier_; }
  [[nodiscard]] const SynthesisCounts& counts() const { return counts_; }
  [[nodiscard]] const StateSpace& space() const { return space_; }

 private:
  void count();

  const StateSpace& space_;
  std::vector<bool> contains_;
  std::vector<Number> frontier_;
  SynthesisCounts counts_;
};

/// What of a state space is in trouble before anything is taken away.
struct Troubles {
  std::size_t marked = 0;
  std::size_t deadlocks = 0;      ///< not marked, and nothing is possible
  std::size_t blocking = 0;       ///< no marked state can be reached
  std::size_t breaking_spec = 0;  ///< an uncontrollable event is blocked by a spec
};
[[nodiscard]] Troubles troublesOf(const StateSpace& space);

/// The events of the shortest way from the initial state into one that breaks a spec, or from which no marked
/// one can be reached; none, where the initial state is such itself, or there is no such.
[[nodiscard]] std::vector<EventIndex> shortestWayIntoConflict(const StateSpace& space);

}  // namespace cobot_command::automata
