// The newest that a robot has heard from the supervisor, and how far it can be relied on (cell.md, M28).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

class StateWatch {
 public:
  StateWatch(std::string robot, std::uint64_t session, std::string hash, Duration lease)
      : robot_(std::move(robot)), session_(session), hash_(std::move(hash)), lease_(lease) {}

  /// A report of this session went out.
  void told(std::uint64_t report, Instant now);

  /// False: it tells nothing, as it is old, or of another artifact or supervisor.
  bool hear(const CellStatus& state, std::uint64_t number, Instant now);

  /// What it tells of this robot; nullptr: nothing was heard.
  [[nodiscard]] const RobotStatus* mine() const { return mine_ ? &*mine_ : nullptr; }
  [[nodiscard]] SupervisorMode mode() const { return mode_; }
  [[nodiscard]] bool isFinishing() const { return is_finishing_; }
  /// Of the supervisor that it keeps to; 0: none was heard yet.
  [[nodiscard]] std::uint64_t instance() const { return heard_ ? instance_ : 0; }
  /// Why nobody can be asked now; nothing: there is a supervisor.
  [[nodiscard]] std::optional<std::string> silence(Instant now) const;
  /// Why nothing may be done on it now; nothing: it may. By when it was heard, and by which of the robot's
  /// own reports it knows: what a broken network keeps and brings in the end, all at once, is old.
  [[nodiscard]] std::optional<std::string> objection(Instant now) const;

 private:
  [[nodiscard]] bool isOfThisSession() const { return mine_ && mine_->session == session_; }

  std::string robot_;
  std::uint64_t session_;
  std::string hash_;
  Duration lease_;
  // Of the newest state, which is not kept as a whole: a large cell tells many, and long ones.
  std::uint64_t instance_ = 0;
  std::uint64_t epoch_ = 0;
  std::uint64_t number_ = 0;
  SupervisorMode mode_ = SupervisorMode::Starting;
  bool is_finishing_ = false;
  std::optional<RobotStatus> mine_;
  std::optional<Instant> heard_;
  std::map<std::uint64_t, Instant> reports_;  ///< of this session that are no older than the lease, by number
  std::optional<Instant> known_at_;           ///< when the newest report was told that the supervisor knows
  std::optional<Instant> heard_other_;        ///< supervisor, or artifact
  std::string other_;
};

}  // namespace cobot_command::cell
