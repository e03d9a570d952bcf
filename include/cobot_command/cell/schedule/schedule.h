// When each event of all robots happens so that the last of them is home as early as can be (cell.md, M36).
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
  std::size_t robot = 0;  ///< into Problem::automata
  automata::EventIndex event = 0;
  Duration at{};      ///< since the start
  Duration waited{};  ///< longer than it had to, for the sake of others
};

struct ScheduledHold {
  std::size_t robot = 0;
  std::optional<automata::EventIndex> booking;  ///< none: it is held from the start
  /// The last event up to the booking that can be refused: itself, or one that it follows by itself. None:
  /// nothing can be, or that was for the robot's hold before this one.
  std::optional<automata::EventIndex> decision;
  Duration from{};
  Duration until{};
};

/// Who holds a zone before whom.
struct ZoneOrder {
  std::size_t zone = 0;  ///< its spec, into Problem::automata
  std::vector<ScheduledHold> holds;
};

struct Schedule {
  std::vector<ScheduledEvent> events;  ///< in the order in which they happen
  std::vector<ZoneOrder> zones;        ///< of all zones that several robots use
  Duration makespan{};                 ///< when the last robot is home
};

struct ScheduleLimits {
  std::size_t max_expanded = 2000000;  ///< entries of the search that are gone on from
  std::function<bool()> is_over;       ///< asked now and then; true: ends with the best found so far
};

struct FoundSchedule {
  std::optional<Schedule> best;    ///< none: a limit was reached before any
  Duration bound{};                ///< no schedule is shorter
  Duration one_after_the_other{};  ///< what it takes when each robot waits until the one before it is home
  std::size_t expanded = 0;

  [[nodiscard]] bool isOptimal() const { return best && best->makespan == bound; }
  /// How much shorter a schedule may yet be. Precondition: there is a best one.
  [[nodiscard]] Duration gap() const { return best->makespan - bound; }
};

/// The shortest schedule of all in which each event is granted when it happens. Same input, same schedule.
///
/// A fault is a sentence for each line: those of the cycles; or that there is no way for all to come home.
[[nodiscard]] Result<FoundSchedule, std::string> findSchedule(const automata::Supervisor& supervisor,
                                                              const std::vector<RobotCycle>& cycles,
                                                              const ScheduleLimits& limits = {});
[[nodiscard]] Result<FoundSchedule, std::string> findSchedule(const automata::SafeOrder& rule,
                                                              const std::vector<RobotCycle>& cycles,
                                                              const ScheduleLimits& limits = {});

}  // namespace cobot_command::cell
