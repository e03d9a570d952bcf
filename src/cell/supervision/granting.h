// Which of those who wait goes next, and why the others do not.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "supervision/cell_record.h"
#include "supervision/hindrance_memo.h"
#include "supervision/robot_watch.h"
#include "supervision/zone_turns.h"

#include "cobot_command/cell/model/rules.h"
#include "cobot_command/cell/supervision/cell_state.h"

namespace cobot_command::cell {

struct GrantingConditions {
  bool grants = true;         ///< nothing holds the whole cell
  bool is_finishing = false;  ///< none sets out from home any more
  Duration aging{};
  /// Whether a robot may be granted anything at all.
  std::function<bool(RobotIndex)> is_able;
  /// Who stands in a zone that is not its own; nobody, mostly.
  std::function<std::optional<RobotIndex>(ZoneIndex)> intruder;
  const ZoneTurns* turns = nullptr;  ///< lives longer
  HindranceMemo* memo = nullptr;     ///< likewise
};

/// So long a robot that stands at home and asks for nothing may still come for its turn.
inline constexpr Duration kTurnPatience = std::chrono::seconds(1);

class Granting {
 public:
  Granting(const Rules& rules, const CellRecord& record, const std::vector<RobotWatch>& robots,
           GrantingConditions conditions)
      : rules_(rules), record_(record), robots_(robots), conditions_(std::move(conditions)) {}

  /// The oldest that can be granted; nobody: all that wait have a hindrance.
  [[nodiscard]] std::optional<RobotIndex> next(Instant now) const;
  /// Of one that waits.
  [[nodiscard]] std::optional<Hindrance> hindranceOf(RobotIndex robot, Instant now) const;
  /// For the sake of the schedule alone.
  [[nodiscard]] bool isKeptBackForLong(RobotIndex robot, Instant now) const;
  /// The robots that wait, the one that waits for longest first.
  [[nodiscard]] std::vector<RobotIndex> queue() const;

 private:
  /// Another one's than that of a robot that waits, by the schedule.
  [[nodiscard]] std::optional<RobotIndex> whoseTurn(RobotIndex robot, Instant now) const;
  [[nodiscard]] Situation situation(Instant now) const;
  [[nodiscard]] std::optional<Hindrance> findHindrance(RobotIndex robot, Instant now) const;
  /// Those who have waited for long, and for whose sake others wait.
  [[nodiscard]] std::vector<Helped> findHelped(Instant now) const;
  /// What is in its way besides those who have waited for longer.
  [[nodiscard]] std::optional<Hindrance> ownHindrance(RobotIndex robot) const;
  [[nodiscard]] std::optional<Hindrance> hindranceByZones(const CellEvent& event) const;
  [[nodiscard]] bool canBeHelped(RobotIndex robot, const std::vector<RobotIndex>& ahead) const;
  /// One that has waited for long, and for whose sake that robot has to wait.
  [[nodiscard]] std::optional<RobotIndex> agedBefore(RobotIndex robot, Instant now) const;

  const Rules& rules_;
  const CellRecord& record_;
  const std::vector<RobotWatch>& robots_;
  GrantingConditions conditions_;
};

}  // namespace cobot_command::cell
