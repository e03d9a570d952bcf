// A schedule with all events as early as its orders on the zones let them be.
#pragma once

#include <vector>

#include "search.h"
#include "workload.h"

namespace cobot_command::cell {

/// By zone: its holds in the order in which they happen. Those of no length are told apart by the order of
/// the events, as their times are the same.
[[nodiscard]] std::vector<std::vector<CycleHold>> holdsInOrder(const Workload& work,
                                                               const std::vector<Move>& moves);

/// The search lets a robot wait at home as soon as on its way, and at run time an order holds back bookings
/// only. So this is what the cell does under it. As it was, where the rule would not grant that.
[[nodiscard]] std::vector<Move> compacted(const Workload& work, const std::vector<Move>& moves,
                                          const Rule& rule, const automata::Tuple& initial);

}  // namespace cobot_command::cell
