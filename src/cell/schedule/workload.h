// Cycles as a search needs them: by index, with the times summed up and the zones that are held on the way.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/automata/problem.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// From one event of a robot to a later one; both are indices of its cycle.
struct CycleHold {
  std::size_t robot = 0;               ///< into Workload::robots
  std::optional<std::size_t> booking;  ///< none: from the start
  /// The last one up to the booking that can be kept waiting; none: all are reports, or it has
  /// decided on the hold before as well.
  std::optional<std::size_t> decision;
  std::optional<std::size_t> release;  ///< none: to the end
};

struct Workload {
  struct Robot {
    std::size_t plant = 0;
    std::vector<automata::EventIndex> events;
    std::vector<bool> is_report;
    std::vector<Duration> after;
    std::vector<Duration> alone;  ///< when each event happens at the earliest, from the start

    [[nodiscard]] std::size_t size() const { return events.size(); }
    [[nodiscard]] Duration length() const { return alone.back(); }
    /// From one event to a later one, at least.
    [[nodiscard]] Duration between(std::size_t event, std::size_t later) const {
      return alone[later] - alone[event];
    }
  };
  /// A spec that several robots use, and one of them holds at a time.
  struct Zone {
    std::size_t automaton = 0;
    std::vector<CycleHold> holds;  ///< those of a robot in their order
  };
  std::vector<Robot> robots;
  std::vector<Zone> zones;
};

/// Precondition: faultsOfCycles(problem, cycles) is empty.
[[nodiscard]] Workload workloadOf(const automata::Problem& problem, const std::vector<RobotCycle>& cycles);

}  // namespace cobot_command::cell
