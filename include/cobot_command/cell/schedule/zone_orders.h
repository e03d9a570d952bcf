// How many ways there are for robots to hold their zones one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/robot_cycle.h"

namespace cobot_command::cell {

struct ZoneOrderCounts {
  std::uint64_t orders = 1;  ///< of all zones together; the greatest number: that many or more
  /// In which robots wait for each other in a circle, so that they never come home; none: more orders had to
  /// be looked at than were allowed.
  std::optional<std::uint64_t> circular;
};

/// Precondition: faultsOfCycles(problem, cycles) is empty.
[[nodiscard]] ZoneOrderCounts countZoneOrders(const automata::Problem& problem,
                                              const std::vector<RobotCycle>& cycles,
                                              std::size_t max_looked_at = 1000000);

}  // namespace cobot_command::cell
