// The supervisor behind its façade.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "supervision/cell_record.h"
#include "supervision/granting.h"
#include "supervision/robot_watch.h"
#include "supervision/zone_turns.h"

#include "cobot_command/cell/supervision/supervision.h"

namespace cobot_command::cell {

class Supervision::Parts {
 public:
  Parts(Rules rules, std::string hash, std::uint64_t instance, const std::vector<journal::Record>& records,
        SupervisionSettings settings, SupervisionPorts ports);

  bool take(const RobotReport& report, Instant now);
  /// Looks at all that time alone changes, and grants what can be granted.
  void settle(Instant now);

  PersonsAnswer hold(bool on, Instant now);
  PersonsAnswer finish(bool on, Instant now);
  PersonsAnswer stop(Instant now);
  PersonsAnswer recover(const std::string& robot, const std::string& place, const std::string& person,
                        Instant now);
  PersonsAnswer confirmClear(const std::string& robot, const std::string& person, bool was_moved,
                             Instant now);
  PersonsAnswer takeOut(const std::string& robot, const std::string& person, Instant now);

  [[nodiscard]] CellStatus status(Instant now) const;
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  [[nodiscard]] const automata::Tuple& tuple() const { return record_.tuple(); }
  [[nodiscard]] const SupervisionCounts& counts() const { return counts_; }

 private:
  // --- Reports.
  void join(RobotIndex robot);
  void takeEvents(RobotIndex robot, Instant now);
  /// False: nothing behind it is looked at any more.
  bool takeEvent(RobotIndex robot, const NumberedEvent& event, Instant now);
  bool takeWithdrawal(RobotIndex robot, const NumberedEvent& event);
  void fail(RobotIndex robot, const std::string& why);
  void findIntruders();

  [[nodiscard]] std::optional<std::string> objectionToRecovery(RobotIndex robot, automata::StateIndex place,
                                                               const std::string& person, Instant now) const;

  // --- What follows.
  void grant(Instant now);
  [[nodiscard]] Granting granting(Instant now) const;
  [[nodiscard]] bool isAble(RobotIndex robot, Instant now) const;
  [[nodiscard]] bool isLost(RobotIndex robot, Instant now) const;
  /// The robot's own session is not the one that is listened to.
  [[nodiscard]] bool isStrange(RobotIndex robot) const;
  [[nodiscard]] SupervisorMode mode() const;
  /// Robots that have to be recovered before anything goes on behind a restart.
  [[nodiscard]] std::vector<RobotIndex> unconfirmed() const;

  // --- How things stand.
  [[nodiscard]] RobotState stateOf(RobotIndex robot, Instant now) const;
  [[nodiscard]] RobotStatus statusOf(RobotIndex robot, Instant now) const;
  [[nodiscard]] ZoneStatus statusOfZone(ZoneIndex zone, Instant now) const;
  [[nodiscard]] std::string diagnosis() const;
  [[nodiscard]] std::string textOf(RobotIndex robot, Instant now) const;
  [[nodiscard]] const std::string& nameOf(RobotIndex robot) const {
    return rules_.model().program.robots[robot].name;
  }
  [[nodiscard]] std::vector<std::string> namesOf(const std::vector<RobotIndex>& robots) const;

  Rules rules_;
  std::string hash_;
  SupervisionSettings settings_;
  SupervisionPorts ports_;
  CellRecord record_;
  ZoneTurns turns_;
  std::vector<RobotWatch> robots_;
  mutable HindranceMemo memo_;
  std::vector<std::optional<RobotIndex>> zone_holders_;  ///< by zone
  std::vector<std::optional<RobotIndex>> intruders_;     ///< by zone: who is in it, though it is not its own
  std::set<std::array<std::size_t, 3>> intrusions_;      ///< zone, robot, other: that last, and were stopped
  std::vector<Instant> zone_since_;                      ///< by zone: since when its holder is the same
  Instant settled_at_{};                                 ///< what was due until then has been done
  bool is_restarted_ = false;                            ///< with a journal that has robots in it
  std::vector<bool> is_confirmed_;  ///< by robot: since the start it has heard of us, and told where it is
  std::string start_fault_;         ///< why the journal cannot be gone on with
  SupervisionCounts counts_;
};

}  // namespace cobot_command::cell
