// One command, from its frame to its one end (states: command_run_states.h).
//
// It is told everything that may concern it, and takes what does. The same for every block: what differs is
// in its order. Its time, what the status stream shows of it, and what is told of it are parts of their own.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "forecast/command_order.h"
#include "runs/command_clock.h"
#include "runs/command_reports.h"
#include "runs/command_run_states.h"
#include "runs/evidence.h"
#include "stops/stop_run.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/robot/reason_wait.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

/// What a running command uses of the core.
struct RunContext {
  const link::LinkSettings& settings;
  link::ScriptLink& link;
  link::TagLedger& tags;
  const robot::RobotWatch& robot;
  StopRun& stop;
  const arm::ArmModel* arm;  ///< nullptr: no model
};

class CommandRun {
 public:
  /// Sends the script. Precondition: the link is Ready.
  CommandRun(CommandOrder order, const RunContext& context, Instant now);
  CommandRun(const CommandRun&) = delete;
  CommandRun& operator=(const CommandRun&) = delete;

  /// Stops the robot; ends as CommandAborted with `why` once it stands. A command that does not move is left
  /// to its end, which is as near as its reply.
  void cancel(const std::string& why, Instant now);
  /// Ends it now, as CommandAborted; the robot is told to stop, and nobody waits for the answer.
  void abandon(const std::string& why, Instant now);

  void answered(const link::ScriptAnswered& answer, Instant now);
  /// The tag, open until now, was reported complete: Done, when the status stream shows it too. `followed`:
  /// the robot goes on with the command behind it, so that it need not be seen to stand.
  void tagCompleted(bool followed, Instant now);
  /// The mark of that tag was reported: which one it is. Those in front of it are passed, too, though nobody
  /// said so: tags complete in their order. Precondition: its order has that mark.
  [[nodiscard]] std::size_t passMark(int tag);
  void tagFailed(Instant now);
  /// The answer to the question that it asked, other than "complete".
  void tagIncomplete(protocol::TagState state, Instant now);
  void tagQueryFailed(const std::string& reason, Instant now);
  void stopEnded(const StopRun::Result& result, Instant now);
  void linkLost(const std::string& reason, Instant now);
  /// A status frame came, or the status stream stopped.
  void robotChanged(Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const { return clock_.next(); }
  /// It is made at another project speed than it was planned for: the plan for that one, from there.
  void retime(const Origin& origin, Plan plan);

  [[nodiscard]] const CommandOrder& order() const { return order_; }
  [[nodiscard]] bool accepted() const { return accepted_at_.has_value(); }
  /// For how long the controller has had it, less the holds.
  [[nodiscard]] Duration waited(Instant now) const { return clock_.waited(now); }
  [[nodiscard]] bool stopping() const { return state_ == CommandRunState::Stopping; }
  [[nodiscard]] bool mayBeCancelled() const;
  /// The controller has it, or may have it, and its end is not known.
  [[nodiscard]] bool underWay() const;
  /// It has the robot stopped, or had.
  [[nodiscard]] bool asksForStop() const { return stop_ > stop_in_front_; }
  [[nodiscard]] bool ended() const { return state_ == CommandRunState::Ended; }
  /// Precondition: ended().
  [[nodiscard]] const blocks::Outcome& outcome() const { return outcome_; }
  /// What is new since the last call.
  [[nodiscard]] std::vector<blocks::Progress> takeProgress() { return reports_.take(); }

 private:
  enum class Robot { LeaveIt, Stop };

  void fire(CommandRunEvent event, Instant now);
  void act(CommandRunAction action, Instant now);
  void fail(blocks::Failure failure, Robot robot, Instant now,
            CommandRunEvent event = CommandRunEvent::Failed);
  void awaitTag(Instant now);
  void askForStop(Instant now);

  void beginVerifying(Instant now);
  void verify(Instant now);
  void judge(Instant now);
  void awaitReason(Instant now);
  void lookForReason(Instant now);
  void end(blocks::Outcome outcome, Instant now);

  CommandOrder order_;
  RunContext context_;
  CommandRunState state_ = CommandRunState::Sent;
  std::string script_id_;
  Instant sent_at_;
  std::optional<Instant> accepted_at_;
  std::optional<Instant> tag_seen_at_;
  std::optional<Instant> asked_at_;  ///< for the tag after its deadline, first
  CommandClock clock_;
  Evidence evidence_;
  CommandReports reports_;
  robot::ReasonWait reason_;
  blocks::Failure failure_;
  Robot robot_on_failure_ = Robot::LeaveIt;
  StopRun::Number stop_in_front_;  ///< the last one when it was sent
  StopRun::Number stop_ = 0;       ///< that it has asked for
  bool followed_ = false;          ///< the command behind it takes the robot over
  bool is_to_be_seen_ = false;     ///< its tag came: the status stream should show it at its end
  std::string cancelled_why_;
  std::string stopped_how_;
  blocks::Remarks remarks_;
  blocks::Outcome outcome_;
};

}  // namespace cobot_command::command
