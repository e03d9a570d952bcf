#include "paths/load_path_run.h"

#include <algorithm>
#include <utility>

#include "paths/path_outcomes.h"

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::blocks {
namespace {

bool refusesToEnterAPvt(const Outcome& outcome) {
  const auto& lines = outcome.refused_lines;
  return std::any_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return line.rfind("PVTEnter", 0) == 0; });
}

}  // namespace

LoadPathRun::LoadPathRun(GoalId id, const PathReport& planned, Instant now)
    : Run(kBlock<LoadPathGoal>, id), goals_(reports(), id, planned), waits_from_(now) {}

// --- What is sent.

std::size_t LoadPathRun::window() const {
  const PathChain& pieces = goals_.pieces();
  const LoadedPath* const next = pieces.nextOf();
  const bool has_pvt = !pieces.sent().empty() && pieces.sent().front().piece->is_exact;  // with many tags
  if (next == nullptr || next->execution != Execution::Script || has_pvt) return 2;
  return static_cast<std::size_t>(next->settings.buffer) + 1;
}

std::optional<Command> LoadPathRun::next() const {
  if (restore_.isOwed()) return restore_.command();
  const PathChain& pieces = goals_.pieces();
  const LoadedPiecePtr piece = pieces.next();
  const bool waits = restarting_ || pieces.isNextOpen() || !goals_.mayGoOn();
  if (state_ != State::Following || !piece || waits) return std::nullopt;
  Command command;
  command.key = pieces.nextKey();
  command.block = block();
  command.traits.awaits_motion = true;
  command.order = [piece](const arm::Pose& /*base*/) { return piece->order; };
  return command;
}

void LoadPathRun::commandStarted(CommandKey key) {
  if (key == PathRestore::kKey) {
    restore_.started();
  } else {
    goals_.pieces().sendNext();
    record_.sent(goals_.pieces());
  }
}

/// With nothing at the controller it waits for its time; else to the last moment, as the robot would rest in
/// front of it anyway.
std::optional<Instant> LoadPathRun::openEndDue() const {
  const PathChain& pieces = goals_.pieces();
  if (state_ != State::Following || !pieces.isNextOpen()) return std::nullopt;
  const Duration wait = pieces.members().back().loaded->settings.chain_wait;
  if (pieces.sent().empty()) return waits_from_ + wait;
  if (pieces.sent().size() == 1 && goals_.pieceEnd()) return *goals_.pieceEnd() - wait;
  return std::nullopt;
}

void LoadPathRun::advance(Instant now) {
  const auto due = openEndDue();
  if (due && now >= *due) goals_.pieces().letOpenEndGo();
  if (reason_until_ && now >= *reason_until_) fire(Event::Failed, now);
  if (!outcome()) goals_.tellStatus(now);
}

std::optional<Instant> LoadPathRun::nextDeadline() const {
  return earlier(earlier(openEndDue(), reason_until_), goals_.statusDue());
}

// --- What becomes of it.

void LoadPathRun::commandProgressed(CommandKey key, const Progress& progress, Instant now) {
  if (goals_.pieces().sent().isFirst(key)) goals_.progressed(progress, now);
}

void LoadPathRun::commandPassed(CommandKey key, std::size_t mark, Instant now) {
  if (!goals_.pieces().sent().isFirst(key)) return;
  const PathChain::Sent& sent = goals_.pieces().sent().front();
  done(sent.first + sent.piece->marked[mark] + 1, now);
}

void LoadPathRun::commandEnded(CommandKey key, const Outcome& outcome, Instant now) {
  PathChain& pieces = goals_.pieces();
  if (key == PathRestore::kKey && restore_.isSent()) {
    restore_.ended();
    if (outcome.ending != Ending::Done) stopped_why_ += PathRestore::kNotRestored;
    fire(Event::NothingLeft, now);
    return;
  }
  if (!pieces.sent().has(key)) {  // stopped before it was
    endEarly(outcome, now);
    return;
  }
  if (restarting_ && state_ == State::Following && outcome.ending == Ending::CommandAborted) {
    record_.came(goals_.takeBack(key, now));
    return;
  }
  ended_at_.final_joints_deg = outcome.final_joints_deg;
  ended_at_.final_pose_mm_deg = outcome.final_pose_mm_deg;
  const bool was_first = pieces.sent().isFirst(key);
  const std::size_t behind = pieces.sent().take(key).behind();
  if (was_first) waits_from_ = now;
  if (outcome.ending != Ending::Done) {
    if (was_first) record_.came(goals_.pieceEnded(now));
    endEarly(outcome, now);
    return;
  }
  done(behind, now);
  record_.came(goals_.pieceEnded(now));
  if (!pieces.sent().empty()) {
    goals_.begin(now);
  } else if (state_ != State::Following) {
    endWhenNothingIsLeft(now);
  }
}

void LoadPathRun::endEarly(const Outcome& outcome, Instant now) {
  if (outcome.ending == Ending::CommandAborted) {
    const bool is_told =
        restarting_ && state_ == State::Stopping;  // what it was stopped for is another thing
    if (!outcome.error_description.empty() && !is_told) stopped_why_ = outcome.error_description;
    fire(Event::Cancel, now);
  } else {
    pvt_refused_ = pvt_refused_ || refusesToEnterAPvt(outcome);
    fail(failureOf(block(), outcome), now);
  }
  endWhenNothingIsLeft(now);
}

void LoadPathRun::commandRefused(CommandKey key, const Failure& failure, Instant now) {
  if (key == PathRestore::kKey) {
    restore_.ended();
    stopped_why_ += PathRestore::kNotRestored + (": " + failure.found);
    fire(Event::NothingLeft, now);
    return;
  }
  fail(failure, now);
  endWhenNothingIsLeft(now);
}

/// The first one is the reason; what follows is of it.
void LoadPathRun::fail(Failure failure, Instant now) {
  if (!failure_) {
    failure_ = std::move(failure);
  } else if (failure.error_id == own_error::kStopNotConfirmed) {
    failure_->found += "; " + failure.found;
  }
  fire(Event::Failed, now);
}

void LoadPathRun::endWhenNothingIsLeft(Instant now) {
  if (!goals_.pieces().sent().empty() || restore_.isSent()) return;
  // Nothing is sent to a robot that may still move.
  const bool may_move = failure_ && failure_->error_id == own_error::kStopNotConfirmed;
  restore_.begin(may_move ? Order() : goals_.pieces().restoring());
  if (!restore_.isOwed()) fire(Event::NothingLeft, now);
}

std::optional<std::string> LoadPathRun::stopsFor() const {
  const bool stops = state_ == State::Failing && failure_->error_id == own_error::kPathDeviates;
  return stops ? std::optional("it is off its path") : std::nullopt;
}

void LoadPathRun::done(std::size_t points, Instant now) {
  if (!outcome() && goals_.done(points, now)) fire(Event::LastDone, now);
}

void LoadPathRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  if (outcome()) return;
  goals_.robotChanged(robot, now);
  record_.robotChanged(robot);
  if (state_ == State::Following) {
    if (auto deviation = goals_.deviation()) fail(*std::move(deviation), now);
  }
  if (!goals_.pieces().sent().empty()) return;
  if (robot.emergencyStop() || robot.inError()) {
    failure_ = robot.emergencyStop() ? emergencyStop() : robotError(robot);
    fire(Event::Failed, now);
    endWhenNothingIsLeft(now);
  } else if (state_ == State::Explaining) {
    tellStoppedProject(robot, *failure_);
    if (!robot.status() || reason_.endsWithFrame(now)) fire(Event::Failed, now);
  } else if (restarting_ && state_ == State::Following) {
    goOnFrom(robot, now);
  }
}

void LoadPathRun::goOnFrom(const robot::RobotWatch& robot, Instant now) {
  restarting_ = false;
  if (robot.joints()) {
    goals_.rewind(*robot.joints(), now);
    record_.stopped(*robot.joints());
    return;
  }
  fail({own_error::kRestNotPlanned, "the status stream does not show where the robot is", ""}, now);
  endWhenNothingIsLeft(now);
}

// --- Ends that are asked for.

void LoadPathRun::cancel(const std::string& why, Instant now) {
  if (state_ == State::Following) {
    stopped_why_ = why + (restarting_ ? "; the robot was stopped" : "; no motion was running");
  }
  fire(Event::Cancel, now);
  endWhenNothingIsLeft(now);
}

void LoadPathRun::interrupt(const std::string& why, Instant now) {
  if (state_ == State::Following) interrupted_ = true;
  cancel(why, now);
}

void LoadPathRun::finish(FinishAfter /*after*/, Instant now) {
  constexpr const char* kWhy = "no motion is started after a finish";
  goals_.dropUntouched(kWhy, now);
  if (goals_.pieces().isUnbegun()) cancel(kWhy, now);
}

void LoadPathRun::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  if (!goals_.pieces().sent().empty() || state_ != State::Following) return;
  failure_ = Failure{motion_error::kLinkDropped, reason, ""};
  if (patience) reason_until_ = now + *patience;
  fire(Event::Unexplained, now);
  if (!patience) fire(Event::Failed, now);
}

// --- What it is controlled by from outside.

void LoadPathRun::use(const path::PathControls& controls, Instant now) {
  if (outcome()) return;
  goals_.use(controls, now);
  if (auto failure = goals_.replan().takeFailure(); failure && state_ == State::Following) {
    fail(*std::move(failure), now);
    endWhenNothingIsLeft(now);
  }
}

/// What is taken back gets the next feedrate, as what was not sent does.
PathPace LoadPathRun::pace() const {
  PathPace pace = goals_.pace();
  pace.can_restart = state_ == State::Following && !restarting_ && pace.running;
  const bool is_taken_back = restarting_ || goals_.pieces().isRewound();
  pace.is_restarting = state_ == State::Following && is_taken_back;
  if (pace.is_restarting) {
    pace.running.reset();
    pace.next_point = pace.active_point;
    pace.highest = pace.highest_of_all;
  }
  return pace;
}

void LoadPathRun::restart() {
  restarting_ = state_ == State::Following && !goals_.pieces().sent().empty();
}

/// Once the last point in front is under way: what is automatic would be in its way until then.
std::optional<path::TrackingFlags> LoadPathRun::wantedTracking() const {
  const PathMember* const waits = goals_.pieces().firstAtGate();
  const bool is_next = waits != nullptr && goals_.place().behind_active >= waits->first;
  return state_ == State::Following && is_next ? std::optional(waits->loaded->tracking) : std::nullopt;
}

std::optional<PathWork> LoadPathRun::takeReplan() {
  return state_ == State::Following ? goals_.replan().take() : std::nullopt;
}

std::optional<std::string> LoadPathRun::replanned(const Detail& found) {
  return state_ == State::Following ? goals_.replan().answered(found) : std::nullopt;
}

// --- Ends.

void LoadPathRun::fire(Event event, Instant now) {
  const auto row = findTransition<LoadPathTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  if (state_ != State::Following) goals_.stay();
  if (state_ == State::Ended) goals_.endStatus();
  const PathChain& pieces = goals_.pieces();
  switch (row->action) {
    case LoadPathAction::None:
      return;
    case LoadPathAction::AwaitReason:
      reason_.begin(now);
      return;
    case LoadPathAction::EndDone:
      end(goals_.complete(pieces.members().front(), ended_at_, now));
      return;
    case LoadPathAction::EndStopped:
      end(goals_.endAll(stoppedOutcomes(pieces, goals_.place(), {stopped_why_, interrupted_}), now));
      return;
    case LoadPathAction::EndFailed:
      reason_until_.reset();
      end(goals_.endAll(failedOutcomes(pieces, goals_.place(), *failure_), now));
      return;
  }
}

}  // namespace cobot_command::blocks
