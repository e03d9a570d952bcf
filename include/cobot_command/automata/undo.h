// A booking that nothing was done with, taken back (cell.md, M33).
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

  /// Controllable, and a spec has it: what it takes could be given back.
  [[nodiscard]] bool isBooking(EventIndex event) const { return is_booking_[event]; }
  /// Where all automata that have the event were before it, if it is the last thing that they did; none,
  /// where one of them is not right behind it, or could have come there from two states.
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
  std::size_t bookings = 0;  ///< pairs of a state of the supervisor and a booking that can be undone there
  std::size_t outside = 0;   ///< of which undone would leave the supervisor
};
[[nodiscard]] UndoCounts countUndoes(const Synthesis& synthesis, const Problem& problem);

}  // namespace cobot_command::automata
