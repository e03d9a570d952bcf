// Takes back an unused booking (doc/cell.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/synthesis.h"

namespace cobot_command::automata {

class Undo {
 public:
  /// Precondition: faultsOf(problem) is empty.
  explicit Undo(const Problem& problem);

  /// True for a controllable event of a spec: what it takes can be returned.
  [[nodiscard]] bool isBooking(EventIndex event) const { return is_booking_[event]; }
  /// The state before the event, of all automata that have it, if it was their last event. std::nullopt if
  /// one of them is not in a state directly after it, or could have reached that state from two states.
  [[nodiscard]] std::optional<Tuple> before(const Tuple& tuple, EventIndex event) const;

 private:
  struct Participant {
    std::size_t automaton = 0;
    std::vector<StateIndex> previous;  ///< by local state
  };
  std::vector<std::vector<Participant>> participants_;  ///< by event
  std::vector<bool> is_booking_;
};

struct UndoCounts {
  std::size_t bookings = 0;  ///< pairs of a supervisor state and a booking that can be taken back there
  std::size_t outside = 0;   ///< of these: taking back would leave the supervisor
};
[[nodiscard]] UndoCounts countUndoes(const Synthesis& synthesis, const Problem& problem);

}  // namespace cobot_command::automata
