// CBT_Connect (thesis 5.3.1): opens both links, stays Busy while it supervises them, closes them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "failure.h"
#include "output_board.h"

#include "cobot_command/blocks/connect_run_states.h"
#include "cobot_command/blocks/goal.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/status_link.h"

namespace cobot_command::blocks {

/// All violations of the goal's parameters, in table order.
[[nodiscard]] std::vector<Failure> checkConnect(const ConnectGoal& goal);

class ConnectRun {
 public:
  ConnectRun(const link::LinkSettings& settings, link::ScriptLink& script, link::StatusLink& status,
             OutputBoard& board);

  /// Precondition: not busy(), and checkConnect() found nothing.
  void execute(GoalId id, const ConnectGoal& goal, Instant now);
  /// Motions have to be ended first; then motionsEnded().
  void cancel(Instant now);
  void motionsEnded(Instant now);
  void abandon(const std::string& why, Instant now);

  /// The state or the diagnosis of the script link is another one.
  void linkChanged(Instant now);
  void linkLost(const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const { return deadline_; }

  [[nodiscard]] bool busy() const { return state_ != ConnectState::Idle; }
  [[nodiscard]] bool disconnecting() const { return state_ == ConnectState::Disconnecting; }
  [[nodiscard]] GoalId goal() const { return id_; }
  /// Of the goal that is Busy, or of the last one.
  [[nodiscard]] const ConnectGoal& target() const { return goal_; }
  [[nodiscard]] std::optional<Instant> lastConnected() const { return last_connected_; }
  [[nodiscard]] std::optional<Instant> lastLost() const { return last_lost_; }

 private:
  void fire(ConnectEvent event, Instant now);
  void act(ConnectAction action, Instant now);
  void end(Outcome outcome, Instant now);
  void report();
  [[nodiscard]] int statusPort() const { return goal_.status_port.value_or(settings_.status_port); }

  const link::LinkSettings& settings_;
  link::ScriptLink& script_;
  link::StatusLink& status_;
  OutputBoard& board_;
  ConnectState state_ = ConnectState::Idle;
  GoalId id_ = 0;
  ConnectGoal goal_;
  std::optional<Instant> deadline_;
  bool connected_ = false;  ///< was Ready since the last loss
  std::string loss_;
  std::optional<std::pair<Phase, std::string>> reported_;  ///< the last progress
  std::optional<Instant> last_connected_;
  std::optional<Instant> last_lost_;
};

}  // namespace cobot_command::blocks
