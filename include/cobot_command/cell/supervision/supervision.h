// Who may go where next, for all robots of a cell: takes their reports, grants what they want, and tells how
// things stand.
//
// Pure: an event and the time in, the state and what to do out. One thread owns it. What was carried out is
// in the journal before anyone is told.
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

/// By zone: the robots that book it in one cycle of all, in their order; empty: whoever comes first.
using ZoneOrders = std::vector<std::vector<RobotIndex>>;

struct SupervisionSettings {
  Duration lease = std::chrono::milliseconds(500);  ///< silent for longer, a robot is lost
  Duration aging = std::chrono::seconds(10);        ///< a request that is older goes first
  /// Robots take turns on the zones, as long as nobody fails; empty: they do not.
  ZoneOrders turns = {};
  std::size_t most_records = 100000;  ///< of the journal, before it is made anew
};

/// What a supervisor asks about the robots that it knows only by number.
struct SupervisionPorts {
  journal::Append append;
  journal::Replace replace;  ///< empty: the journal grows on
  /// Whether a robot with those joints [rad] stands where that place of its program is.
  std::function<bool(RobotIndex robot, automata::StateIndex place, const std::array<double, 6>& joints)> fits;
};

/// A robot is to be stopped, whatever it does.
struct StopOrder {
  RobotIndex robot = 0;
  std::string why;
};

/// What a person has asked for: whether it was done, and a sentence.
struct PersonsAnswer {
  bool success = false;
  std::string message;
};

/// What was not even looked at, for diagnostics.
struct SupervisionCounts {
  std::uint64_t malformed = 0;
  std::uint64_t unknown_robots = 0;
  std::uint64_t wrong_sessions = 0;
  std::uint64_t old_reports = 0;
  std::uint64_t other_supervisors = 0;
};

class Supervision {
 public:
  /// `hash`: the digest of the artifact. `records`: of the journal; empty: it is new. `instance` is that of a
  /// new journal. The first record is appended at once.
  Supervision(Rules rules, std::string hash, std::uint64_t instance,
              const std::vector<journal::Record>& records, SupervisionSettings settings,
              SupervisionPorts ports);
  ~Supervision();

  // --- What happens.
  /// False: it tells nothing, as it is malformed, old, or of nobody who is listened to.
  bool take(const RobotReport& report, Instant now);
  void tick(Instant now);

  // --- What people ask for.
  /// Nothing new is granted; what was sent goes to its end.
  PersonsAnswer hold(bool on, Instant now);
  /// None sets out from home any more; all end there.
  PersonsAnswer finish(bool on, Instant now);
  PersonsAnswer stop(Instant now);
  PersonsAnswer recover(const std::string& robot, const std::string& place, const std::string& person,
                        Instant now);
  /// `was_moved`: the robot is not any more where it was measured last.
  PersonsAnswer confirmClear(const std::string& robot, const std::string& person, bool was_moved,
                             Instant now);
  PersonsAnswer takeOut(const std::string& robot, const std::string& person, Instant now);

  // --- How things stand.
  [[nodiscard]] CellStatus status(Instant now) const;
  [[nodiscard]] const automata::Tuple& tuple() const;
  [[nodiscard]] const SupervisionCounts& counts() const;
  /// Since the last call, in their order.
  [[nodiscard]] std::vector<StopOrder> takeStopOrders();
  /// When tick() has something to do, if nothing else happens before.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
