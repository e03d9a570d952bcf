// How often all robots can make their cycles when they go on and on (cell.md, S6).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// The least time in which each robot makes one cycle, again and again, over all orders on the zones that
/// repeat from cycle to cycle and begin with all at home. `after` of a robot's first event is the time that
/// it rests at home at least. None: no order leads home, or more had to be looked at than was allowed.
///
/// Precondition: faultsOfCycles(problem, cycles) is empty.
[[nodiscard]] std::optional<Duration> leastPeriod(const automata::Problem& problem,
                                                  const std::vector<RobotCycle>& cycles,
                                                  std::size_t max_looked_at = 100000);

}  // namespace cobot_command::cell
