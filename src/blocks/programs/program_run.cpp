#include "programs/program_run.h"

#include <utility>
#include <vector>

#include "list/block_kinds.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"

namespace cobot_command::blocks {
namespace {

/// Between two reports of a wait that stays what it is.
constexpr Duration kTellEvery = std::chrono::milliseconds(500);

Command commandOfFrame(const ProgramFrame& frame) {
  RunScriptGoal script;
  script.script = fmt::format("{}", fmt::join(frame.lines, "\r\n"));
  script.await_motion = frame.stands;
  Command command = commandOf(script);
  command.traits.ends_blend = false;
  command.traits.asks_permit = true;
  return command;
}

bool isOfThePermit(const Failure& failure) {
  return failure.error_id >= own_error::kNotPermitted && failure.error_id <= own_error::kRecoveryNeeded;
}

}  // namespace

ProgramRun::ProgramRun(GoalId id, ProgramGuidePtr guide, const ProgramRequest& request, Instant now)
    : Run(kBlock<RunProgramGoal>, id), guide_(std::move(guide)), started_at_(now), now_(now) {
  if (auto objection = guide_->begin(request, now)) fail(std::move(*objection), now);
}

ProgramRun::~ProgramRun() {
  if (state_ != State::Ended) static_cast<void>(guide_->end(now_));
}

std::optional<Command> ProgramRun::next() const {
  if (under_way_ || cancelled_why_) return std::nullopt;
  std::optional<Command> command;
  if (state_ == State::Setting) command = commandOf(*frame_.output);
  const bool may_leave = state_ == State::Waiting && !ends_behind_move_;
  if (may_leave && guide_->permitted() != nullptr) command = commandOfFrame(*guide_->permitted());
  if (command) command->key = commands_;
  return command;
}

void ProgramRun::commandStarted(CommandKey /*key*/) {
  under_way_ = true;
  ++commands_;
  if (state_ != State::Waiting) return;
  frame_ = *guide_->permitted();
  guide_->sent(now_);
  fire(Event::FrameSent, now_);
}

void ProgramRun::commandProgressed(CommandKey /*key*/, const Progress& progress, Instant now) {
  tell(progress, now);
}

void ProgramRun::commandEnded(CommandKey /*key*/, const Outcome& outcome, Instant now) {
  now_ = now;
  under_way_ = false;
  if (guide_->failure()) return fail(*guide_->failure(), now);
  if (outcome.ending == Ending::Aborted || outcome.ending == Ending::Rejected) {
    if (isError(blockOfPart(), outcome.error_id, motion_error::kLinkDropped)) {
      return fail(failureOf(blockOfPart(), outcome), now);
    }
    return failFrame(state_ == State::Setting ? own_error::kOutputFailed : own_error::kStepFailed, outcome,
                     now);
  }
  if (outcome.ending == Ending::CommandAborted) cancelled_why_ = outcome.error_description;
  if (cancelled_why_) return fire(Event::Cancelled, now);
  goOn(now);
}

void ProgramRun::commandRefused(CommandKey /*key*/, const Failure& failure, Instant now) {
  if (isOfThePermit(failure)) {
    guide_->refused(now);
    const bool is_gone = guide_->permitted() == nullptr && !guide_->failure();
    // Its permit has ended between two looks: it waits for another one, as it had without that frame.
    return is_gone ? follow(now) : fail(failure, now);
  }
  failFrame(state_ == State::Setting ? own_error::kOutputFailed : own_error::kStepRefused,
            toOutcome(blockOfPart(), Ending::Rejected, failure), now);
}

Block ProgramRun::blockOfPart() const {
  if (state_ == State::Setting) return kBlock<SetOutputGoal>;
  return state_ == State::Awaiting ? kBlock<WaitForInputGoal> : kBlock<RunScriptGoal>;
}

/// Behind a part of the step that is over.
void ProgramRun::goOn(Instant now) {
  const bool has_moved = state_ == State::Moving;
  const bool is_set = has_moved || state_ == State::Setting;
  const bool has_waited = is_set || state_ == State::Awaiting;
  if (has_moved && frame_.output) {
    fire(Event::OutputNext, now);
  } else if (is_set && frame_.input) {
    fire(Event::InputNext, now);
  } else if (has_waited && frame_.dwell > 0) {
    fire(Event::DwellNext, now);
  } else {
    fire(Event::StepDone, now);
  }
}

std::optional<std::string> ProgramRun::stopsFor() const {
  if (!under_way_ || !guide_->failure() || !guide_->stopsRobot()) return std::nullopt;
  return guide_->failure()->found;
}

void ProgramRun::cancel(const std::string& why, Instant now) {
  now_ = now;
  if (wait_) {
    wait_->cancel(why, now);
    return followWait(now);
  }
  if (!cancelled_why_) cancelled_why_ = why + "; no motion was running";
  if (!under_way_) fire(Event::Cancelled, now);
}

void ProgramRun::finish(FinishAfter after, Instant now) {
  guide_->finish();
  if (after != FinishAfter::Move) return;
  ends_behind_move_ = true;
  if (under_way_) return;
  if (!cancelled_why_) cancelled_why_ = "finished on request, after this move";
  fire(Event::Cancelled, now);
}

void ProgramRun::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  now_ = now;
  if (under_way_) return;
  if (wait_) {
    wait_->linkLost(reason, patience, now);
    return followWait(now);
  }
  failure_ = {motion_error::kLinkDropped, reason, ""};
  if (patience) waits_until_ = now + *patience;
  fire(patience ? Event::Unexplained : Event::Failed, now);
}

void ProgramRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  now_ = now;
  if (outcome()) return;
  if (!under_way_) {
    if (robot.emergencyStop()) return fail(emergencyStop(), now);
    if (robot.inError()) return fail(robotError(robot), now);
    if (wait_) {
      wait_->robotChanged(robot, now);
      return followWait(now);
    }
    if (state_ == State::Explaining) {
      tellStoppedProject(robot, failure_);
      if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
      return;
    }
    followHold(robot.held(), now);
  }
  follow(now);
}

void ProgramRun::follow(Instant now) {
  if (outcome() || under_way_ || state_ == State::Explaining) return;
  if (guide_->failure()) return fail(*guide_->failure(), now);
  if (state_ != State::Waiting) return;
  if (guide_->isOver()) return fire(Event::AllDone, now);
  tellWaiting(now);
}

void ProgramRun::followHold(bool held, Instant now) {
  if (held && !held_since_) {
    held_since_ = now;
  } else if (!held && held_since_) {
    if (waits_until_) *waits_until_ += now - *held_since_;
    held_since_.reset();
  }
}

void ProgramRun::advance(Instant now) {
  now_ = now;
  if (wait_) {
    wait_->advance(now);
    return followWait(now);
  }
  const bool is_due = waits_until_ && !held_since_ && now >= *waits_until_;
  if (!under_way_ && is_due) {
    waits_until_.reset();
    if (state_ == State::Explaining) return fire(Event::Failed, now);
    goOn(now);
  }
  follow(now);
}

std::optional<Instant> ProgramRun::nextDeadline() const {
  if (wait_) return wait_->nextDeadline();
  if (!under_way_ && waits_until_ && !held_since_) return waits_until_;
  return state_ == State::Waiting ? guide_->nextDeadline() : std::nullopt;
}

void ProgramRun::fail(Failure failure, Instant now) {
  failure_ = std::move(failure);
  fire(Event::Failed, now);
}

void ProgramRun::failFrame(int error_id, const Outcome& outcome, Instant now) {
  const ProgramStand stand = guide_->stand(now);
  fail({error_id,
        fmt::format("{} step {}, cycle {}: {} {}", stand.path, stand.step + 1, stand.cycle,
                    errorNumber(outcome.error_id), outcome.error_description),
        outcome.remedy},
       now);
}

void ProgramRun::fire(Event event, Instant now) {
  const auto row = findTransition<ProgramTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  act(row->action, now);
}

void ProgramRun::act(ProgramAction action, Instant now) {
  switch (action) {
    case ProgramAction::None:
      return;
    case ProgramAction::StartWait:
      return startWait(now);
    case ProgramAction::StartDwell:
      return startDwell(now);
    case ProgramAction::GoOn:
      guide_->done(now);
      return follow(now);
    case ProgramAction::AwaitReason:
      held_since_.reset();
      return reason_.begin(now);
    case ProgramAction::EndDone:
      return endAs(Ending::Done, now);
    case ProgramAction::EndError:
      return endAs(Ending::Aborted, now);
    case ProgramAction::EndAborted:
      return endAs(Ending::CommandAborted, now);
  }
}

void ProgramRun::startWait(Instant now) {
  wait_ = runOf(*frame_.input, goal(), {}, now);
  followWait(now);
}

void ProgramRun::followWait(Instant now) {
  for (auto& [goal, progress] : wait_->reports().takeProgress()) tell(std::move(progress), now);
  if (!wait_->outcome()) return;
  const auto done = std::exchange(wait_, nullptr);
  commandEnded(commands_, *done->outcome(), now);
}

void ProgramRun::startDwell(Instant now) {
  waits_until_ = now + fromSeconds(frame_.dwell);
  Progress progress;
  progress.phase = Phase::Dwelling;
  progress.text = fmt::format("waits {} s", frame_.dwell);
  tell(std::move(progress), now);
}

void ProgramRun::tellWaiting(Instant now) {
  const ProgramStand stand = guide_->stand(now);
  if (told_at_ && stand.text == told_ && now - *told_at_ < kTellEvery) return;
  told_ = stand.text;
  Progress progress;
  progress.phase = Phase::Queued;
  progress.place_in_queue = stand.place_in_queue;
  progress.text = stand.text;
  tell(std::move(progress), now);
}

void ProgramRun::tell(Progress progress, Instant now) {
  told_at_ = now;
  progress.detail = Detail(ProgramProgress{guide_->stand(now)});
  report(std::move(progress));
}

void ProgramRun::endAs(Ending ending, Instant now) {
  waits_until_.reset();
  wait_.reset();
  std::vector<Duration> waited = guide_->end(now);
  const ProgramStand stand = guide_->stand(now);
  Outcome outcome;
  if (ending == Ending::Aborted) {
    outcome = toOutcome(kBlock<RunProgramGoal>, ending, failure_);
  } else {
    outcome.ending = ending;
    outcome.error_description = cancelled_why_.value_or("");
  }
  outcome.detail = Detail(ProgramReport{stand.cycles_done, stand.place, std::move(waited)});
  outcome.actual = now - started_at_;
  end(std::move(outcome));
}

}  // namespace cobot_command::blocks
