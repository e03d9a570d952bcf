// What every state table must satisfy.
#pragma once

#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cobot_command/common/transition_table.h"

namespace cobot_command::testing {

template <class Enum>
std::vector<Enum> allUpTo(Enum last) {
  std::vector<Enum> all;
  for (int i = 0; i <= static_cast<int>(last); ++i) all.push_back(static_cast<Enum>(i));
  return all;
}

/// No pair twice, an unlisted pair has no row, every state can be reached, and left (but `final`, if any).
template <class Table, class State, class Event>
void expectSoundTable(State last_state, Event last_event, State initial,
                      const std::set<State>& final_states = {}) {
  std::set<std::pair<State, Event>> listed;
  std::set<State> reached{initial};
  for (const auto& row : Table::kRows) {
    EXPECT_TRUE(listed.emplace(row.from, row.event).second) << "a pair is listed twice";
    reached.insert(row.to);
  }
  for (const State state : allUpTo(last_state)) {
    EXPECT_EQ(reached.count(state), 1u) << "state " << static_cast<int>(state) << " is never reached";
    bool left = false;
    for (const Event event : allUpTo(last_event)) {
      const auto row = findTransition<Table>(state, event);
      EXPECT_EQ(row.has_value(), listed.count({state, event}) == 1);
      left = left || (row && row->to != state);
    }
    EXPECT_EQ(left, final_states.count(state) == 0) << "state " << static_cast<int>(state);
  }
}

}  // namespace cobot_command::testing
