// The newest that a robot has heard from the supervisor, and how far it can be relied on (cell.md, M28).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

class StateWatch {
 public:
  StateWatch(std::string robot, std::string hash, Duration lease)
      : robot_(std::move(robot)), hash_(std::move(hash)), lease_(lease) {}

  /// False: it tells nothing, as it is old, or of another artifact or supervisor.
  bool hear(const CellStatus& state, std::uint64_t number, Instant now);

  /// What it tells of this robot; nullptr: nothing was heard.
  [[nodiscard]] const RobotStatus* mine() const;
  [[nodiscard]] const CellStatus& state() const { return state_; }
  /// Of the supervisor that it keeps to; 0: none was heard yet.
  [[nodiscard]] std::uint64_t instance() const { return heard_ ? state_.instance : 0; }
  /// Why nothing may be done on it now; nothing: it may.
  [[nodiscard]] std::optional<std::string> objection(Instant now) const;
  /// From when on there is an objection, if nothing is heard.
  [[nodiscard]] std::optional<Instant> expires() const;

 private:
  std::string robot_;
  std::string hash_;
  Duration lease_;
  CellStatus state_;
  std::uint64_t number_ = 0;
  std::optional<Instant> heard_;
  std::optional<Instant> heard_other_;  ///< supervisor, or artifact
  std::string other_;
};

}  // namespace cobot_command::cell
