// A pick-and-place goal under way (annex B, chapter 6.3.8; states: pick_and_place_states.h).
//
// Every step lives on the wire exactly like a command of its own.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runs/pick_and_place_states.h"

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/common/time.h"
#include "cobot_command/robot/reason_wait.h"

namespace cobot_command::blocks {

/// How long one cycle takes, its dwells included, by what the check of its steps found; nothing when that did
/// not see them all.
[[nodiscard]] std::optional<Duration> plannedCycle(const PickAndPlaceGoal& goal,
                                                   const std::vector<StepReport>& steps);

class PickAndPlaceRun final : public Run {
 public:
  /// `steps`: what the check of the sequence found; may be empty. Precondition: the goal's check() found
  /// nothing.
  PickAndPlaceRun(GoalId id, PickAndPlaceGoal goal, std::vector<StepReport> steps, Instant now);

  [[nodiscard]] bool leavesMotions() const override { return true; }
  /// In a dwell only the exit, when finish() has made it the last one.
  [[nodiscard]] std::optional<Command> next() const override;
  /// Which cycle is the last, finish() may change until the move is done.
  [[nodiscard]] bool leavesNode() const override;
  void commandStarted(CommandKey /*key*/) override {
    under_way_ = true;
    ++commands_;
  }
  void commandProgressed(CommandKey key, const Progress& progress, Instant now) override;
  void commandEnded(CommandKey key, const Outcome& outcome, Instant now) override;
  void commandRefused(CommandKey key, const Failure& failure, Instant now) override;

  /// A link that was lost already stays the reason.
  void cancel(const std::string& why, Instant now) override;
  /// Nothing more is begun behind the command that is under way, also no exit (a dwell ends at once), or
  /// behind this cycle, whose exit is then due.
  void finish(FinishAfter after, Instant now) override;
  void linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) override;
  /// A pause holds the dwell; an emergency stop or an error ends it.
  void robotChanged(const robot::RobotWatch& robot, Instant now) override;
  void setAside(Instant now) override;
  void putBack(Instant now) override;
  void advance(Instant now) override;
  [[nodiscard]] std::optional<Instant> nextDeadline() const override;

 private:
  using Event = PickAndPlaceEvent;

  void fire(Event event, Instant now);
  /// Without its key.
  [[nodiscard]] std::optional<Command> nextPart() const;
  /// Of the step: a command, or the wait for an input.
  void endPart(const Outcome& outcome, Instant now);
  /// Whose errors the part under way has.
  [[nodiscard]] Block blockOfPart() const;
  /// Behind a part of the step that is over.
  void goOn(Instant now);
  void startWait(Instant now);
  /// What its wait for an input tells, and how that ended.
  void followWait(Instant now);
  void followHold(bool held, Instant now);
  void startDwell(Instant now);
  void tellDwell();
  void tellFailure();
  void nextStep();
  void blame(Failure failure);
  void fail(Failure failure, Instant now);
  void failStep(int error_id, Failure step_failure, const std::string& remedy, Instant now);
  void tell(Progress progress);
  void endAs(Ending ending, Instant now);
  [[nodiscard]] const PickAndPlaceStep& step() const { return goal_.steps[step_]; }
  [[nodiscard]] bool isLast() const;
  [[nodiscard]] bool beginsNoMore() const { return cancelled_why_ || ends_behind_move_; }

  PickAndPlaceGoal goal_;
  PickAndPlaceState state_ = PickAndPlaceState::Moving;
  std::size_t step_ = 0;
  int cycle_ = 1;
  bool under_way_ = false;
  CommandKey commands_ = 0;                   ///< that have been sent
  std::optional<std::string> cancelled_why_;  ///< and what became of the robot
  std::string finished_why_;                  ///< it is to end behind this cycle, or this move
  bool ends_behind_move_ = false;
  bool owes_exit_ = false;              ///< its last move was done before it was known to be the last
  std::unique_ptr<Run> wait_;           ///< for the input of the step
  std::optional<Instant> waits_until_;  ///< in a dwell, or for a reason
  robot::ReasonWait reason_;
  std::optional<Instant> held_since_;
  Instant started_at_;
  Failure failure_;
  std::optional<Duration> planned_cycle_;
  CycleReport found_;  ///< until now
};

}  // namespace cobot_command::blocks
