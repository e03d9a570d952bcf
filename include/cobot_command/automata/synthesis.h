// Synthesis of the supervisor: the largest reachable behaviour that is permitted, controllable and
// non-blocking.
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
  std::size_t refused_beyond_spec = 0;  ///< pairs of a state and an event that only the supervisor refuses
  std::size_t frontier = 0;             ///< states that only the supervisor prevents
};

/// The state space must outlive it.
class Synthesis {
 public:
  using Number = StateSpace::Number;

  /// Removes states that violate a spec, states from which an uncontrollable event leads to a removed state,
  /// and states from which no marked state is reachable, until a fixed point. Then removes unreachable
  /// states.
  explicit Synthesis(const StateSpace& space);

  /// Nothing remains: even the initial state cannot be kept.
  [[nodiscard]] bool empty() const { return !contains_[0]; }
  [[nodiscard]] bool contains(Number state) const { return contains_[state]; }
  /// States outside that a controllable event would reach from inside, ascending. In addition to the specs, a
  /// supervisor only has to avoid these.
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

/// Problems of a state space before any state is removed.
struct Troubles {
  std::size_t marked = 0;
  std::size_t deadlocks = 0;      ///< not marked, and no event is possible
  std::size_t blocking = 0;       ///< no marked state is reachable
  std::size_t breaking_spec = 0;  ///< an uncontrollable event is blocked by a spec
};
[[nodiscard]] Troubles troublesOf(const StateSpace& space);

/// The events of the shortest path from the initial state to a state that violates a spec, or from which no
/// marked state is reachable. Empty if this is the initial state itself, or if there is no such state.
[[nodiscard]] std::vector<EventIndex> shortestWayIntoConflict(const StateSpace& space);

}  // namespace cobot_command::automata
