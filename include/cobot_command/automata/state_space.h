// The reachable states of a composition, and the events between them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/packed_states.h"
#include "cobot_command/automata/range.h"
#include "cobot_command/common/result.h"

namespace cobot_command::automata {

struct TooManyStates {
  std::size_t limit = 0;
};

class StateSpace {
 public:
  using Number = PackedStates::Number;
  struct Edge {
    EventIndex event = 0;
    Number to = 0;
  };
  /// All states that are reachable from the initial state, which has number 0, breadth first. The composition
  /// must outlive the state space.
  [[nodiscard]] static Result<StateSpace, TooManyStates> explore(const Composition& composition,
                                                                 std::size_t max_states);

  [[nodiscard]] Number size() const { return states_.size(); }
  [[nodiscard]] std::size_t edgeCount() const { return edges_.size(); }
  [[nodiscard]] Range<Edge> edges(Number state) const {
    return {edges_.data() + first_edges_[state], edges_.data() + first_edges_[state + 1]};
  }
  [[nodiscard]] bool isMarked(Number state) const { return marked_[state]; }
  /// True if an uncontrollable event is possible in all its plants and blocked by a spec.
  [[nodiscard]] bool breaksSpec(Number state) const { return breaks_spec_[state]; }
  /// The number of controllable events that are possible in all their plants and blocked by a spec.
  [[nodiscard]] std::size_t refusedBySpec(Number state) const { return refused_by_spec_[state]; }

  [[nodiscard]] const PackedStates& states() const { return states_; }
  [[nodiscard]] const Composition& composition() const { return *composition_; }

 private:
  explicit StateSpace(const Composition& composition) : composition_(&composition), states_(composition) {}
  void expand(const Tuple& from, Tuple& to);

  const Composition* composition_;
  PackedStates states_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> first_edges_ = {0};  ///< by state, plus one end entry
  std::vector<bool> marked_;
  std::vector<bool> breaks_spec_;
  std::vector<std::uint16_t> refused_by_spec_;
};

}  // namespace cobot_command::automata
