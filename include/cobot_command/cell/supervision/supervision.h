// The supervisor of a cell at run time: receives the reports of all robots, grants their requests, and
// provides the state to publish.
//
// Pure: its inputs are events and the time, its outputs the state and stop orders. Owned by one thread. Every
// event is in the journal before it is published; only a stop order is given before its reason is written.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/model/rules.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/journal.h"
#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// By zone: the robots that book it in one cycle of all robots, in order; empty: first come, first served.
using ZoneOrders = std::vector<std::vector<RobotIndex>>;

struct SupervisionSettings {
  Duration lease = std::chrono::milliseconds(500);  ///< a robot that is silent for longer is lost
  Duration aging = std::chrono::seconds(10);        ///< an older request has priority
  /// Robots take turns on the zones as long as no robot fails; empty: no turns.
  ZoneOrders turns = {};
  std::size_t most_records = 100000;  ///< of the journal, before it is compacted
};

/// A robot must be stopped, whatever it does.
struct StopOrder {
  RobotIndex robot = 0;
  std::string why;
};

/// Services that the supervisor needs; robots are identified by number.
struct SupervisionPorts {
  journal::Append append;
  journal::Replace replace;  ///< empty: the journal is never compacted
  /// True if a robot with those joints [rad] is at that place of its program.
  std::function<bool(RobotIndex robot, automata::StateIndex place, const std::array<double, 6>& joints)> fits;
  /// Called before anything is appended because of it: the disk of the journal may take long.
  std::function<void(const StopOrder& order)> stop;
};

/// Answer to an operator: whether the request was done, and a sentence.
struct PersonsAnswer {
  bool success = false;
  std::string message;
};

/// Unused reports, for diagnostics.
struct SupervisionCounts {
  std::uint64_t malformed = 0;
  std::uint64_t unknown_robots = 0;
  std::uint64_t wrong_sessions = 0;
  std::uint64_t old_reports = 0;
  std::uint64_t other_supervisors = 0;
};

class Supervision {
 public:
  /// `hash`: the digest of the artifact. `records`: of the journal; empty: a new one. `instance` is that of a
  /// new journal. The first record is appended immediately.
  Supervision(Rules rules, std::string hash, std::uint64_t instance,
              const std::vector<journal::Record>& records, SupervisionSettings settings,
              SupervisionPorts ports);
  ~Supervision();

  // --- Inputs.
  /// Returns false if the report is ignored: malformed, old, or from an unknown robot or session.
  bool take(const RobotReport& report, Instant now);
  void tick(Instant now);

  // --- Operator requests.
  /// Nothing new is granted; sent motions run to their end.
  PersonsAnswer hold(bool on, Instant now);
  /// No robot starts from home any more; all goals end there.
  PersonsAnswer finish(bool on, Instant now);
  PersonsAnswer stop(Instant now);
  PersonsAnswer recover(const std::string& robot, const std::string& place, const std::string& person,
                        Instant now);
  /// `was_moved`: the robot is no longer at its last measured position.
  PersonsAnswer confirmClear(const std::string& robot, const std::string& person, bool was_moved,
                             Instant now);
  PersonsAnswer takeOut(const std::string& robot, const std::string& person, Instant now);

  // --- State and outputs.
  [[nodiscard]] CellStatus status(Instant now) const;
  [[nodiscard]] const automata::Tuple& tuple() const;
  [[nodiscard]] const SupervisionCounts& counts() const;
  /// The time of the next tick(), if nothing else happens before.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
