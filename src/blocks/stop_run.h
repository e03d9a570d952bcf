// Stops the robot and empties its queue, whoever wants that: a cancel, a failed command, the stop block, a
// command that takes over (states: stop_run_states.h).
//
// It has a path of its own to the wire: the frame goes out in the same event, whatever waits or runs.
#pragma once

#include <optional>
#include <string>

#include "failure.h"
#include "robot_watch.h"

#include "cobot_command/blocks/stop_run_states.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/tag_ledger.h"

namespace cobot_command::blocks {

class StopRun {
 public:
  /// How a stop ended: the robot stands, or why that is not certain.
  struct Result {
    std::optional<Failure> failure;
    bool refused = false;  ///< the controller said no: what it had queued goes on
    bool confirmed =
        true;  ///< it was seen to stand; false: the controller accepted the stop, and that is all
  };
  static constexpr const char* kNotSeen =
      "the controller accepted the stop, but no status stream tells whether the robot stands";

  StopRun(const link::LinkSettings& settings, link::ScriptLink& link, link::TagLedger& tags,
          const RobotWatch& robot)
      : settings_(settings), link_(link), tags_(tags), robot_(robot) {}

  /// Whatever the state of the link: a stop is worth a try. Does nothing without a connection: then nobody
  /// can be told.
  void ask(Instant now);
  [[nodiscard]] bool busy() const { return state_ != StopState::Idle; }

  void answered(const link::ScriptAnswered& answer, Instant now);
  void linkLost(const std::string& reason, Instant now);
  void robotChanged(Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const { return deadline_; }

  /// Once for each end.
  [[nodiscard]] std::optional<Result> takeResult();

 private:
  void fire(StopEvent event, Instant now);
  void fail(Failure failure, Instant now);

  const link::LinkSettings& settings_;
  link::ScriptLink& link_;
  link::TagLedger& tags_;
  const RobotWatch& robot_;
  StopState state_ = StopState::Idle;
  std::string script_id_;
  std::optional<Instant> deadline_;  ///< of the standstill
  bool told_ = false;                ///< the status stream told whether the robot moves, when it was asked
  Failure failure_;
  bool refused_ = false;
  std::optional<Result> result_;
};

}  // namespace cobot_command::blocks
