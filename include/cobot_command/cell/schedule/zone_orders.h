// Counts the orders in which robots can hold their zones one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/robot_cycle.h"

namespace cobot_command::cell {

struct ZoneOrderCounts {
  std::uint64_t orders = 1;  ///< of all zones together; the largest number means that many or more
  /// Orders in which robots wait for each other in a cycle, so that they never reach home; std::nullopt: the
  /// search exceeded its limit.
  std::optional<std::uint64_t> circular;
};

/// Precondition: faultsOfCycles(problem, cycles) is empty.
[[nodiscard]] ZoneOrderCounts countZoneOrders(const automata::Problem& problem,
                                              const std::vector<RobotCycle>& cycles,
                                              std::size_t max_looked_at = 1000000);

}  // namespace cobot_command::cell
