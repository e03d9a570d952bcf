// State machines as tables: one row for each pair of state and event that has an effect.
//
// A pair that is not listed is an event too late (or too early) for the state: the state does not change and
// no action is executed.
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

/// The row of (state, event) in Table::kRows; std::nullopt if the pair is not listed.
template <class Table, class State, class Event>
[[nodiscard]] constexpr std::optional<typename Table::Row> findTransition(State state, Event event) {
  for (const typename Table::Row& row : Table::kRows) {
    if (row.from == state && row.event == event) return row;
  }
  return std::nullopt;
}

}  // namespace cobot_command
