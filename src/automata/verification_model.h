// K as verification builds it for itself: slower and simpler than the state space of the synthesis, and
// nothing of it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/problem.h"

namespace cobot_command::automata::verification {

struct Edge {
  EventIndex event = 0;
  std::uint32_t to = 0;
};

struct State {
  Tuple tuple;
  std::vector<Edge> edges;  ///< in byte order of the names of their events
  bool is_marked = false;
  bool breaks_spec = false;  ///< an uncontrollable event that all plants can make is blocked
  std::uint32_t refused_by_spec = 0;
};

class Model {
 public:
  explicit Model(const Problem& problem);

  /// From the initial state, which is the first one; false: there are more than `max_states`.
  [[nodiscard]] bool explore(std::size_t max_states);
  [[nodiscard]] const std::vector<State>& states() const { return states_; }
  [[nodiscard]] const Problem& problem() const { return problem_; }

  /// By number of what was explored; nothing: it is none of that.
  [[nodiscard]] std::optional<std::uint32_t> find(const Tuple& tuple) const;
  /// Before the event, which was the last thing that all of its automata did; nothing, where it was not, or
  /// where one of them could have come from two states.
  [[nodiscard]] std::optional<Tuple> before(const Tuple& tuple, EventIndex event) const;
  /// Controllable, and a spec has it.
  [[nodiscard]] bool isBooking(EventIndex event) const;

 private:
  void expand(std::uint32_t number);
  std::uint32_t numberOf(const Tuple& tuple);

  const Problem& problem_;
  std::vector<EventIndex> by_name_;
  std::vector<std::vector<std::size_t>> users_;  ///< by event: automata that have it
  std::vector<std::map<std::pair<StateIndex, EventIndex>, StateIndex>> next_;
  /// Where such a transition comes from; nothing: from several states.
  std::vector<std::map<std::pair<StateIndex, EventIndex>, std::optional<StateIndex>>> previous_;
  std::vector<State> states_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
};

}  // namespace cobot_command::automata::verification
