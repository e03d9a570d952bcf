#include "runs/pick_and_place_run.h"

#include <utility>

#include "list/block_kinds.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::blocks {

using State = PickAndPlaceState;

namespace {

Command exitOfNode() {
  Command command = commandOf(ExitListenNodeGoal{});
  command.leaves_only = true;
  return command;
}

}  // namespace

PickAndPlaceRun::PickAndPlaceRun(GoalId id, PickAndPlaceGoal goal, std::vector<StepReport> steps, Instant now)
    : Run(kBlock<PickAndPlaceGoal>, id), goal_(std::move(goal)), started_at_(now) {
  planned_cycle_ = plannedCycle(goal_, steps);
  steps.resize(goal_.steps.size());
  found_.steps = std::move(steps);
}

std::optional<Command> PickAndPlaceRun::next() const {
  auto command = nextPart();
  if (command) command->key = commands_;
  return command;
}

std::optional<Command> PickAndPlaceRun::nextPart() const {
  if (under_way_ || beginsNoMore()) return std::nullopt;
  if (state_ == State::Moving) return commandOf(step().move);
  if (state_ == State::Setting) return commandOf(*step().output);
  if (owes_exit_) return exitOfNode();
  return std::nullopt;
}

bool PickAndPlaceRun::leavesNode() const {
  return isLast() && !beginsNoMore();
}

bool PickAndPlaceRun::isLast() const {
  return step_ + 1 == goal_.steps.size() && goal_.cycles != 0 && cycle_ >= goal_.cycles;
}

void PickAndPlaceRun::commandProgressed(CommandKey /*key*/, const Progress& progress, Instant /*now*/) {
  Progress mine = progress;
  mine.fraction = (static_cast<double>(step_) + progress.fraction) / static_cast<double>(goal_.steps.size());
  tell(std::move(mine));
}

void PickAndPlaceRun::commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant now) {
  endPart(outcome, now);
}

void PickAndPlaceRun::endPart(const Outcome& outcome, Instant now) {
  under_way_ = false;
  if (outcome.ending == Ending::Aborted || outcome.ending == Ending::Rejected) {
    if (isError(blockOfPart(), outcome.error_id, motion_error::kLinkDropped)) {
      fail(failureOf(blockOfPart(), outcome), now);
      return;
    }
    const int id = state_ == State::Setting ? own_error::kOutputFailed : own_error::kStepFailed;
    // Nobody who gave an output has lines to correct: 16#257 has a remedy of its own.
    const bool refused_output =
        state_ == State::Setting && isError(blockOfPart(), outcome.error_id, motion_error::kRejected);
    failStep(id, {outcome.error_id, outcome.error_description, ""}, refused_output ? "" : outcome.remedy,
             now);
    return;
  }
  if (outcome.ending == Ending::CommandAborted || beginsNoMore()) {
    // It is the command that tells what became of the robot.
    if (outcome.ending == Ending::CommandAborted) cancelled_why_ = outcome.error_description;
    fire(Event::Cancelled, now);
    return;
  }
  if (std::exchange(owes_exit_, false)) return;  // the dwell goes on, or is over
  goOn(now);
}

Block PickAndPlaceRun::blockOfPart() const {
  if (state_ == State::Setting) return kBlock<SetOutputGoal>;
  if (state_ == State::Waiting) return kBlock<WaitForInputGoal>;
  return owes_exit_ ? kBlock<ExitListenNodeGoal> : kBlock<MoveAbsoluteGoal>;
}

void PickAndPlaceRun::goOn(Instant now) {
  const bool moved = state_ == State::Moving;
  const bool set = moved || state_ == State::Setting;
  const bool waited = set || state_ == State::Waiting;
  if (moved && step().output) {
    fire(Event::OutputNext, now);
  } else if (set && step().input) {
    fire(Event::InputNext, now);
  } else if (waited && step().dwell > 0) {
    fire(Event::DwellNext, now);
  } else {
    fire(isLast() ? Event::LastDone : Event::StepNext, now);
  }
}

void PickAndPlaceRun::commandRefused(CommandKey /*key*/, const Failure& failure, Instant now) {
  const Outcome refusal = toOutcome(blockOfPart(), Ending::Rejected, failure);
  failStep(state_ == State::Setting ? own_error::kOutputFailed : own_error::kStepRefused,
           {refusal.error_id, refusal.error_description, ""}, refusal.remedy, now);
}

void PickAndPlaceRun::failStep(int error_id, Failure step_failure, const std::string& remedy, Instant now) {
  StepReport& report = found_.steps[step_];
  report.error_id = step_failure.error_id;
  report.error_description = forPeople(step_failure.found);
  const char* part = state_ == State::Setting   ? "the output of "
                     : state_ == State::Waiting ? "the input of "
                                                : "";
  fail({error_id,
        fmt::format("{}step {} of {}, cycle {}: {} {}", part, step_ + 1, goal_.steps.size(), cycle_,
                    errorNumber(step_failure.error_id), step_failure.found),
        remedy},
       now);
}

void PickAndPlaceRun::cancel(const std::string& why, Instant now) {
  if (wait_) {
    wait_->cancel(why, now);
    followWait(now);
    return;
  }
  if (!cancelled_why_) cancelled_why_ = why + "; no motion was running";
  if (!under_way_) fire(Event::Cancelled, now);
}

/// The first wish stays, but for one that is to end sooner. What only looks for its reason is over already.
void PickAndPlaceRun::finish(FinishAfter after, Instant now) {
  if (beginsNoMore() || state_ == State::Explaining) return;
  if (wait_ && after == FinishAfter::Move) {
    wait_->finish(after, now);
    followWait(now);
  } else if (after == FinishAfter::Move) {
    ends_behind_move_ = true;
    finished_why_ = state_ == State::Dwelling ? "finished on request, in a dwell"
                                              : "finished on request, after this move";
    if (!under_way_) fire(Event::Cancelled, now);
  } else if (!isLast()) {
    goal_.cycles = cycle_;
    finished_why_ = fmt::format("finished on request, after cycle {}", cycle_);
    owes_exit_ = state_ == State::Dwelling && isLast() && step().move.exit_node;
  }
}

void PickAndPlaceRun::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  if (under_way_) return;
  if (wait_) {
    wait_->linkLost(reason, patience, now);
    followWait(now);
    return;
  }
  blame({motion_error::kLinkDropped, reason, ""});
  if (patience) waits_until_ = now + *patience;
  fire(patience ? Event::Unexplained : Event::Failed, now);
}

void PickAndPlaceRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  if (under_way_ || outcome()) return;
  if (robot.emergencyStop()) {
    fail(emergencyStop(), now);
    return;
  }
  if (robot.inError()) {
    fail(robotError(robot), now);
    return;
  }
  if (wait_) {
    wait_->robotChanged(robot, now);
    followWait(now);
    return;
  }
  if (state_ == State::Explaining) {
    tellStoppedProject(robot, failure_);
    if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
    return;
  }
  followHold(robot.held(), now);
}

void PickAndPlaceRun::followHold(bool held, Instant now) {
  if (!waits_until_) return;
  if (held && !held_since_) {
    held_since_ = now;
  } else if (!held && held_since_) {
    *waits_until_ += now - *held_since_;
    held_since_.reset();
  }
}

void PickAndPlaceRun::setAside(Instant now) {
  if (wait_) wait_->setAside(now);
  followHold(true, now);
}

void PickAndPlaceRun::putBack(Instant now) {
  if (wait_) {
    wait_->putBack(now);
    followWait(now);
  }
  followHold(false, now);
  if (state_ == State::Dwelling) tellDwell();
}

void PickAndPlaceRun::advance(Instant now) {
  if (wait_) {
    wait_->advance(now);
    followWait(now);
    return;
  }
  if (under_way_ || !waits_until_ || held_since_ || now < *waits_until_) return;
  waits_until_.reset();
  if (state_ == State::Explaining) {
    fire(Event::Failed, now);
  } else {
    goOn(now);
  }
}

std::optional<Instant> PickAndPlaceRun::nextDeadline() const {
  if (wait_) return wait_->nextDeadline();
  return under_way_ || held_since_ ? std::nullopt : waits_until_;
}

/// The step that is under way.
void PickAndPlaceRun::blame(Failure failure) {
  found_.failed_step = static_cast<int>(step_);
  failure_ = std::move(failure);
}

void PickAndPlaceRun::fail(Failure failure, Instant now) {
  blame(std::move(failure));
  fire(Event::Failed, now);
}

void PickAndPlaceRun::fire(Event event, Instant now) {
  const auto row = findTransition<PickAndPlaceTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  switch (row->action) {
    case PickAndPlaceAction::None:
      return;
    case PickAndPlaceAction::StartWait:
      startWait(now);
      return;
    case PickAndPlaceAction::StartDwell:
      startDwell(now);
      return;
    case PickAndPlaceAction::NextStep:
      nextStep();
      return;
    case PickAndPlaceAction::AwaitReason:
      held_since_.reset();
      reason_.begin(now);
      tellFailure();
      return;
    case PickAndPlaceAction::EndDone:
      ++found_.cycles_done;
      endAs(Ending::Done, now);
      return;
    case PickAndPlaceAction::EndError:
      endAs(Ending::Aborted, now);
      return;
    case PickAndPlaceAction::EndAborted:
      endAs(Ending::CommandAborted, now);
      return;
  }
}

void PickAndPlaceRun::startWait(Instant now) {
  wait_ = runOf(*step().input, goal(), {}, now);
  followWait(now);
}

void PickAndPlaceRun::followWait(Instant now) {
  for (auto& [goal, progress] : wait_->reports().takeProgress()) {
    progress.fraction = static_cast<double>(step_ + 1) / static_cast<double>(goal_.steps.size());
    tell(std::move(progress));
  }
  if (!wait_->outcome()) return;
  const auto done = std::exchange(wait_, nullptr);
  endPart(*done->outcome(), now);
}

void PickAndPlaceRun::startDwell(Instant now) {
  waits_until_ = now + fromSeconds(step().dwell);
  tellDwell();
}

void PickAndPlaceRun::tellDwell() {
  Progress progress;
  progress.phase = Phase::Dwelling;
  progress.fraction = static_cast<double>(step_ + 1) / static_cast<double>(goal_.steps.size());
  progress.text = fmt::format("waits {} s", step().dwell);
  tell(std::move(progress));
}

/// Its dwell is over: nothing of it is executed any more.
void PickAndPlaceRun::tellFailure() {
  Progress progress;
  progress.phase = Phase::Stopping;
  progress.text = robot::ReasonWait::text("failed, " + failure_.found);
  tell(std::move(progress));
}

void PickAndPlaceRun::nextStep() {
  if (++step_ < goal_.steps.size()) return;
  step_ = 0;
  ++cycle_;
  ++found_.cycles_done;
}

void PickAndPlaceRun::tell(Progress progress) {
  progress.detail = Detail(CyclePlace{static_cast<int>(step_), cycle_});
  report(std::move(progress));
}

void PickAndPlaceRun::endAs(Ending ending, Instant now) {
  waits_until_.reset();
  wait_.reset();
  Outcome outcome;
  if (ending == Ending::Aborted) {
    outcome = toOutcome(kBlock<PickAndPlaceGoal>, ending, failure_);
  } else {
    outcome.ending = ending;
    outcome.error_description = cancelled_why_.value_or(finished_why_);
  }
  outcome.planned = planned_cycle_;
  outcome.detail = Detail(std::move(found_));
  outcome.actual = now - started_at_;
  end(std::move(outcome));
}

}  // namespace cobot_command::blocks
