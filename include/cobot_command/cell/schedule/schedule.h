// Finds the times of all events of all robots with which the last robot is home as early as possible
// (doc/cell.md).
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/automata/safe_order.h"
#include "cobot_command/automata/supervisor.h"
#include "cobot_command/cell/schedule/robot_cycle.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

struct ScheduledEvent {
  std::size_t robot = 0;  ///< index into Problem::automata
  automata::EventIndex event = 0;
  Duration at{};      ///< since the start
  Duration waited{};  ///< delay in favour of other robots
};

struct ScheduledHold {
  std::size_t robot = 0;
  std::optional<automata::EventIndex> booking;  ///< std::nullopt: held from the start
  /// The last controllable event up to the booking: the booking itself, or the event that it follows
  /// automatically. std::nullopt: there is none, or it belongs to the robot's previous hold.
  std::optional<automata::EventIndex> decision;
  Duration from{};
  Duration until{};
};

/// The order in which robots hold a zone.
struct ZoneOrder {
  std::size_t zone = 0;  ///< its spec, index into Problem::automata
  std::vector<ScheduledHold> holds;
};

struct Schedule {
  std::vector<ScheduledEvent> events;  ///< in order of time
  std::vector<ZoneOrder> zones;        ///< all zones that several robots use
  Duration makespan{};                 ///< when the last robot is home
};

struct ScheduleLimits {
  std::size_t max_expanded = 2000000;  ///< expanded entries of the search
  std::function<bool()> is_over;       ///< polled; true: ends with the best schedule found
};

struct FoundSchedule {
  std::optional<Schedule> best;    ///< std::nullopt: a limit was reached before the first one
  Duration bound{};                ///< no schedule is shorter
  Duration one_after_the_other{};  ///< duration if each robot waits until the previous one is home
  std::size_t expanded = 0;

  [[nodiscard]] bool isOptimal() const { return best && best->makespan == bound; }
  /// How much shorter a schedule might still be. Precondition: there is a best one.
  [[nodiscard]] Duration gap() const { return best->makespan - bound; }
};

/// The shortest schedule in which each event is granted when it happens. The same input gives the same
/// schedule.
///
/// A fault has one sentence per line: faults of the cycles, or that not all robots can reach home.
[[nodiscard]] Result<FoundSchedule, std::string> findSchedule(const automata::Supervisor& supervisor,
                                                              const std::vector<RobotCycle>& cycles,
                                                              const ScheduleLimits& limits = {});
[[nodiscard]] Result<FoundSchedule, std::string> findSchedule(const automata::SafeOrder& rule,
                                                              const std::vector<RobotCycle>& cycles,
                                                              const ScheduleLimits& limits = {});

}  // namespace cobot_command::cell
