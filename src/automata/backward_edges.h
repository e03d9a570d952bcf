// The edges of a state space by where they lead.
#pragma once

#include <cstdint>
#include <vector>

#include "cobot_command/automata/state_space.h"

namespace cobot_command::automata {

class BackwardEdges {
 public:
  /// In one word: there are many.
  struct Edge {
    std::uint32_t from : 31;
    std::uint32_t is_controllable : 1;
  };

  /// Precondition: fewer than 2^31 states.
  explicit BackwardEdges(const StateSpace& space)
      : first_(space.size() + std::size_t{1}), edges_(space.edgeCount()) {
    for (StateSpace::Number state = 0; state < space.size(); ++state) {
      for (const auto& edge : space.edges(state)) ++first_[edge.to];
    }
    // Each stands at its end now, and moves down to its beginning as the edges come in.
    std::size_t end = 0;
    for (std::size_t& first : first_) first = end += first;
    for (StateSpace::Number state = 0; state < space.size(); ++state) {
      for (const auto& edge : space.edges(state)) {
        edges_[--first_[edge.to]] = {state & 0x7FFFFFFFU,
                                     space.composition().isControllable(edge.event) ? 1U : 0U};
      }
    }
  }

  [[nodiscard]] Range<Edge> into(StateSpace::Number state) const {
    return {edges_.data() + first_[state], edges_.data() + first_[state + 1]};
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<Edge> edges_;
};

}  // namespace cobot_command::automata
