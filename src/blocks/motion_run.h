// One accepted motion command, from its frame to its one end (states: motion_run_states.h).
//
// It is told everything that may concern it, and takes what does. The same for every kind of motion.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "failure.h"
#include "output_board.h"
#include "preflight.h"
#include "robot_watch.h"

#include "cobot_command/blocks/goal.h"
#include "cobot_command/blocks/motion_run_states.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::blocks {

/// What a running command uses of the core.
struct RunContext {
  const link::LinkSettings& settings;
  link::ScriptLink& link;
  link::TagLedger& tags;
  const RobotWatch& robot;
  OutputBoard& board;
};

/// What a block makes of a goal that may be sent.
struct MotionOrder {
  Block block = Block::MoveAbsolute;
  GoalId goal = 0;
  int command_id_ack = 0;
  std::optional<int> tag;  ///< open in the ledger; none: done as soon as it is accepted
  std::vector<protocol::ScriptCommand> script;
  bool exits_node = false;
  std::optional<Plan> plan;
};

class MotionRun {
 public:
  /// Accepts the goal and sends the script. Precondition: the link is Ready.
  MotionRun(MotionOrder order, const RunContext& context, Instant now);

  void cancel(Instant now);
  /// Ends it now, as CommandAborted; the robot is told to stop, and nobody waits for the answer.
  void abandon(const std::string& why, Instant now);

  void answered(const link::ScriptAnswered& answer, Instant now);
  /// The tag, open until now, was reported complete.
  void tagCompleted(Instant now);
  void tagFailed(Instant now);
  /// The answer to the question that it asked, other than "complete".
  void tagIncomplete(protocol::TagState state, Instant now);
  void tagQueryFailed(const std::string& reason, Instant now);
  void linkLost(const std::string& reason, Instant now);
  /// A status frame came, or the status stream stopped.
  void robotChanged(Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  [[nodiscard]] const MotionOrder& order() const { return order_; }
  [[nodiscard]] MotionRunState state() const { return state_; }
  [[nodiscard]] bool ended() const { return state_ == MotionRunState::Ended; }

 private:
  enum class Robot { LeaveIt, Stop };

  void fire(MotionRunEvent event, Instant now);
  void act(MotionRunAction action, Instant now);
  void fail(Failure failure, Robot robot, Instant now);
  void scriptAnswered(const link::ScriptAnswered& answer, Instant now);
  void stopAnswered(const link::ScriptAnswered& answer, Instant now);
  void awaitTag(Instant now);
  void awaitStandstill(Instant now);
  void sendStop(Instant now);
  void followHold(Instant now);
  void becomeActiveWhenDue(Instant now);
  void report(Phase phase, std::string text);
  void end(Outcome outcome, Instant now);

  MotionOrder order_;
  RunContext context_;
  MotionRunState state_ = MotionRunState::Sent;
  Phase phase_ = Phase::Sent;
  std::string script_id_;
  std::string stop_id_;
  Instant sent_at_;
  std::optional<Instant> accepted_at_;
  std::optional<Instant> tag_seen_at_;
  std::optional<Instant> active_at_;   ///< when the commands in front of it should be done
  std::optional<Instant> deadline_;    ///< of Executing and of Settling
  std::optional<Instant> held_since_;  ///< the robot is paused: its deadlines stand still
  Instant give_up_at_;                 ///< when nobody can tell whether it moves
  Failure failure_;
  Robot robot_on_failure_ = Robot::LeaveIt;
};

}  // namespace cobot_command::blocks
