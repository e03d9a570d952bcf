// The shortest repetition period of the cycles of all robots (doc/cell.md).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// The shortest period in which each robot makes one cycle, repeatedly, over all orders on the zones that
/// repeat from cycle to cycle and start with all robots at home. `after` of a robot's first event is its
/// minimum rest at home. std::nullopt: no order leads home, or the search exceeded its limit.
///
/// Precondition: faultsOfCycles(problem, cycles) is empty.
[[nodiscard]] std::optional<Duration> leastPeriod(const automata::Problem& problem,
                                                  const std::vector<RobotCycle>& cycles,
                                                  std::size_t max_looked_at = 100000);

}  // namespace cobot_command::cell
