// State machines as tables: one row for each pair of state and event that means something.
//
// A pair that is not listed has one answer everywhere: the state stays and nothing is done, as it is an event
// that comes too late (or too early) for its state.
#pragma once

#include <optional>

namespace cobot_command {

template <class State, class Event, class Action>
struct Transition {
  State from;
  Event event;
  State to;
  Action action;
};

/// The row of (state, event) in Table::kRows; nothing when the pair is not listed.
template <class Table, class State, class Event>
[[nodiscard]] constexpr std::optional<typename Table::Row> findTransition(State state, Event event) {
  for (const typename Table::Row& row : Table::kRows) {
    if (row.from == state && row.event == event) return row;
  }
  return std::nullopt;
}

}  // namespace cobot_command
