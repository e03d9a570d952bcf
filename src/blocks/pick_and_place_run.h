// A pick-and-place goal under way (annex B, chapter 6.3.8; states: pick_and_place_states.h).
//
// It says which command is to be sent next and is told how that went; sending is the arbiter's. So every step
// lives on the wire exactly like a command of its own.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "failure.h"
#include "pick_and_place_states.h"
#include "reason_wait.h"
#include "robot_watch.h"

#include "cobot_command/blocks/finish.h"
#include "cobot_command/blocks/goal.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// All violations of the goal's own parameters, and the first of its steps that is wrong by itself.
[[nodiscard]] std::vector<Failure> checkPickAndPlace(const PickAndPlaceGoal& goal);

/// What to plan to check the cycle as a whole: its steps, which come round when there is more than one cycle.
[[nodiscard]] CheckSequenceGoal asSequence(const PickAndPlaceGoal& goal);

/// How long one cycle takes, its dwells included, by what the check of its steps found; nothing when that did
/// not see them all.
[[nodiscard]] std::optional<Duration> plannedCycle(const PickAndPlaceGoal& goal,
                                                   const std::vector<StepReport>& steps);

class PickAndPlaceRun {
 public:
  using Command = std::variant<MoveAbsoluteGoal, OutputAction, ExitListenNodeGoal>;

  /// `steps`: what the check of the sequence found; may be empty. Precondition: checkPickAndPlace() found
  /// nothing.
  PickAndPlaceRun(GoalId id, PickAndPlaceGoal goal, std::vector<StepReport> steps, Instant now);

  /// What has to be sent now; nothing while a command is under way. In a dwell only the exit, when finish()
  /// has made it the last one.
  [[nodiscard]] std::optional<Command> next() const;
  /// Whether the exit_node of the move that is done now counts: which cycle is the last, finish() may change
  /// until then.
  [[nodiscard]] bool leavesNode() const;
  void commandStarted() { under_way_ = true; }
  void commandProgressed(const Progress& progress);
  void commandEnded(const Outcome& outcome, Instant now);
  /// The command could not be sent.
  void commandRefused(const Failure& failure, Instant now);

  /// When a command is under way that one has to be cancelled too; its end is this one's. A link that was
  /// lost already stays the reason.
  void cancel(const std::string& why, Instant now);
  /// Ends in its own time: nothing more is begun behind the command that is under way, also no exit (a dwell
  /// ends at once), or behind this cycle, whose exit is then due. Changes nothing behind a cancel.
  void finish(FinishAfter after, Instant now);
  /// `patience`: how long the status stream may take to tell why; nothing: there is none.
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now);
  /// A pause holds the dwell; an emergency stop or an error ends it.
  void robotChanged(const RobotWatch& robot, Instant now);
  void advance(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  [[nodiscard]] GoalId goal() const { return id_; }
  [[nodiscard]] bool ended() const { return state_ == PickAndPlaceState::Ended; }
  /// Precondition: ended().
  [[nodiscard]] const Outcome& outcome() const { return outcome_; }
  [[nodiscard]] std::vector<Progress> takeProgress();

 private:
  using Event = PickAndPlaceEvent;

  void fire(Event event, Instant now);
  void startDwell(Instant now);
  void tellFailure();
  void nextStep(Instant now);
  void fail(Failure failure, Instant now);
  void failStep(int error_id, Failure step_failure, const std::string& remedy, Instant now);
  void report(Progress progress);
  void end(Ending ending, Instant now);
  [[nodiscard]] const PickAndPlaceStep& step() const { return goal_.steps[step_]; }
  [[nodiscard]] bool isLast() const;
  [[nodiscard]] bool beginsNoMore() const { return cancelled_why_ || ends_behind_move_; }

  GoalId id_;
  PickAndPlaceGoal goal_;
  PickAndPlaceState state_ = PickAndPlaceState::Moving;
  std::size_t step_ = 0;
  int cycle_ = 1;
  bool under_way_ = false;
  std::optional<std::string> cancelled_why_;  ///< and what became of the robot
  std::string finished_why_;                  ///< it is to end behind this cycle, or this move
  bool ends_behind_move_ = false;
  bool owes_exit_ = false;              ///< its last move was done before it was known to be the last
  std::optional<Instant> waits_until_;  ///< in a dwell, or for a reason
  ReasonWait reason_;
  std::optional<Instant> held_since_;
  Instant started_at_;
  Failure failure_;
  std::vector<Progress> progress_;
  Outcome outcome_;
};

}  // namespace cobot_command::blocks
