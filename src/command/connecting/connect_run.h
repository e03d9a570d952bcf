// CBT_Connect (thesis 5.3.1): opens both links, stays Busy while it supervises them, closes them.
//
// Besides for a goal it can keep a link by itself: without timeout, and without an end.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "board/output_board.h"
#include "connecting/connect_run_states.h"

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/status_link.h"
#include "cobot_command/robot/reason_wait.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class ConnectRun {
 public:
  ConnectRun(const link::LinkSettings& settings, link::ScriptLink& script, link::StatusLink& status,
             const robot::RobotWatch& robot, OutputBoard& board);

  /// For a goal. A link that is kept by itself is taken over when it is to the same controller, else closed
  /// first. Precondition: mayExecute(), and checkConnect() found nothing.
  void execute(blocks::GoalId id, const blocks::ConnectGoal& goal, Instant now);
  /// Without a goal: tries for ever, and again after each loss. Precondition: not busy().
  void keep(const blocks::ConnectGoal& target, Instant now);
  /// Motions have to be ended first; then motionsEnded().
  void cancel(Instant now);
  void motionsEnded(Instant now);
  void abandon(const std::string& why, Instant now);

  /// The state or the diagnosis of the script link is another one.
  void linkChanged(Instant now);
  /// A status frame came, or the status stream stopped.
  void statusChanged(Instant now);
  void linkLost(const std::string& reason, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  /// For a goal, or by itself.
  [[nodiscard]] bool busy() const { return state_ != ConnectState::Idle; }
  [[nodiscard]] bool mayExecute() const { return !busy() || !id_; }
  /// Commands can be sent: the flow is in the Listen node, and it is known where the robot stands, or it was
  /// waited for that long enough.
  [[nodiscard]] bool ready() const {
    return state_ == ConnectState::Supervising && script_.state() == link::ScriptLinkState::Ready;
  }
  [[nodiscard]] bool disconnecting() const { return state_ == ConnectState::Disconnecting; }
  [[nodiscard]] std::optional<blocks::GoalId> goal() const { return id_; }
  /// Is the link that there is one to where the goal wants one?
  [[nodiscard]] bool isSameController(const blocks::ConnectGoal& goal) const;
  /// Of the goal that is Busy, or of the last one.
  [[nodiscard]] const blocks::ConnectGoal& target() const { return goal_; }
  /// Of all goals, and of the link that is kept by itself.
  [[nodiscard]] std::optional<Instant> lastConnected() const { return kept_times_.last_connected; }
  /// The same; a disconnect that was asked for is no loss.
  [[nodiscard]] std::optional<Instant> lastLost() const { return kept_times_.last_lost; }

 private:
  void take(const blocks::ConnectGoal& goal);
  void fire(ConnectEvent event, Instant now);
  void act(ConnectAction action, Instant now);
  void end(blocks::Outcome outcome, Instant now);
  void report();
  void reportLoss();
  void tell(blocks::Progress progress);
  void becomeReadyWhenDue(Instant now);
  void start(Instant now);
  void lookForReason(Instant now);
  [[nodiscard]] int statusPort() const { return goal_.status_port.value_or(settings_.status_port); }

  const link::LinkSettings& settings_;
  link::ScriptLink& script_;
  link::StatusLink& status_;
  const robot::RobotWatch& robot_;
  OutputBoard& board_;
  ConnectState state_ = ConnectState::Idle;
  std::optional<blocks::GoalId> id_;  ///< nothing: kept by itself
  blocks::ConnectGoal goal_;
  std::optional<Instant> deadline_;        ///< of a goal that tries, or of the wait for the reason of a loss
  std::optional<Instant> first_frame_by_;  ///< until then the first status frame is waited for
  bool connected_ = false;                 ///< was Ready since the last loss
  blocks::Failure loss_;
  robot::ReasonWait reason_;
  std::optional<std::pair<blocks::Phase, std::string>> reported_;  ///< the last progress
  blocks::LinkTimes times_;                                        ///< since Execute
  blocks::LinkTimes kept_times_;                                   ///< since the start
};

}  // namespace cobot_command::command
