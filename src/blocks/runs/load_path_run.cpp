#include "runs/load_path_run.h"

#include <algorithm>
#include <utility>

#include "runs/path_outcomes.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"

namespace cobot_command::blocks {
namespace {

/// So many goals may one chain have at a time.
constexpr std::size_t kMostGoals = 64;
/// "tracking object 0 to be on": of those that are not as they should be.
std::string textOfGate(const path::TrackingObjects& objects, const path::TrackingFlags& wanted) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < path::kTrackingObjects; ++i) {
    if (objects[i].on == wanted[i]) continue;
    texts.push_back(fmt::format("tracking object {} to be {}", i, wanted[i] ? "on" : "off"));
  }
  return fmt::format("waits for {}", fmt::join(texts, " and "));
}

}  // namespace

LoadPathRun::LoadPathRun(GoalId id, const PathReport& planned, Instant now)
    : Run(kBlock<LoadPathGoal>, id),
      chain_(id, planned),
      progress_(planned.loaded->end->scene().arm),
      waits_from_(now) {}

// --- What is sent.

std::size_t LoadPathRun::window() const {
  const LoadedPath* const next = chain_.nextOf();
  const bool has_pvt = !chain_.sent().empty() && chain_.sent().front().piece->is_exact;  // with many tags
  if (next == nullptr || next->execution != Execution::Script || has_pvt) return 2;
  return static_cast<std::size_t>(next->settings.buffer) + 1;
}

std::optional<Command> LoadPathRun::next() const {
  if (restore_.isOwed()) return restore_.command();
  const LoadedPiecePtr piece = chain_.next();
  if (state_ != State::Following || !piece || chain_.isNextAtGate()) return std::nullopt;
  if (chain_.isNextOpen() && !open_end_due_) return std::nullopt;
  Command command;
  command.key = chain_.nextKey();
  command.block = block();
  command.traits.awaits_motion = true;
  command.order = [piece](const arm::Pose& /*base*/) { return piece->order; };
  return command;
}

void LoadPathRun::commandStarted(CommandKey key) {
  if (key == PathRestore::kKey) {
    restore_.started();
    return;
  }
  chain_.sendNext();
  open_end_due_ = false;
}

/// With nothing at the controller it waits for its time; else to the last moment, as the robot would rest in
/// front of it anyway.
std::optional<Instant> LoadPathRun::openEndDue() const {
  if (state_ != State::Following || open_end_due_ || !chain_.isNextOpen()) return std::nullopt;
  const Duration wait = chain_.members().back().loaded->settings.chain_wait;
  if (chain_.sent().empty()) return waits_from_ + wait;
  if (chain_.sent().size() == 1 && front_end_) return *front_end_ - wait;
  return std::nullopt;
}

void LoadPathRun::advance(Instant now) {
  const auto due = openEndDue();
  if (due && now >= *due) open_end_due_ = true;
  if (reason_until_ && now >= *reason_until_) fire(Event::Failed, now);
}

std::optional<Instant> LoadPathRun::nextDeadline() const {
  return earlier(openEndDue(), reason_until_);
}

// --- What becomes of it.

void LoadPathRun::commandProgressed(CommandKey key, const Progress& progress, Instant now) {
  if (!chain_.isFirst(key)) return;
  if (phase_ != progress.phase) chain_.tellAnew();
  phase_ = progress.phase;
  text_ = progress.text;
  const Duration duration = chain_.sent().front().piece->plan.duration();
  if (progress.planned && *progress.planned > Duration::zero() && duration > Duration::zero()) {
    rate_ = toSeconds(duration) / toSeconds(*progress.planned);
  }
  if (phase_ == Phase::Active && !progress_.isUnderWay()) begin(now);
  follow(now);
}

void LoadPathRun::begin(Instant now) {
  const PathChain::Sent& first = chain_.sent().front();
  progress_.begin(first, rate_, now);
  front_end_ = now + progress_.remaining(now);
}

void LoadPathRun::commandPassed(CommandKey key, std::size_t mark, Instant now) {
  if (!chain_.isFirst(key)) return;
  const PathChain::Sent& sent = chain_.sent().front();
  done(sent.first + sent.piece->marked[mark] + 1, now);
}

void LoadPathRun::commandEnded(CommandKey key, const Outcome& outcome, Instant now) {
  if (key == PathRestore::kKey && restore_.isSent()) {
    restore_.ended();
    if (outcome.ending != Ending::Done) stopped_why_ += PathRestore::kNotRestored;
    fire(Event::NothingLeft, now);
    return;
  }
  if (!chain_.isSent(key)) {  // stopped before it was
    endEarly(outcome, now);
    return;
  }
  const bool was_first = chain_.isFirst(key);
  const std::size_t behind = chain_.take(key).behind();
  if (was_first) {
    front_end_.reset();
    waits_from_ = now;
  }
  if (outcome.ending == Ending::Done) {
    done(behind, now);
    progress_.end();
    if (!chain_.sent().empty()) {
      begin(now);
    } else if (state_ != State::Following) {
      endWhenNothingIsLeft(now);
    }
    return;
  }
  if (was_first) progress_.end();
  endEarly(outcome, now);
}

void LoadPathRun::endEarly(const Outcome& outcome, Instant now) {
  if (outcome.ending == Ending::CommandAborted) {
    if (!outcome.error_description.empty()) stopped_why_ = outcome.error_description;
    fire(Event::Cancel, now);
  } else {
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
  if (!chain_.sent().empty() || restore_.isSent()) return;
  // Nothing is sent to a robot that may still move.
  const bool may_move = failure_ && failure_->error_id == own_error::kStopNotConfirmed;
  restore_.begin(may_move ? Order() : chain_.restoring());
  if (!restore_.isOwed()) fire(Event::NothingLeft, now);
}

std::optional<std::string> LoadPathRun::stopsFor() const {
  const bool stops = state_ == State::Failing && failure_->error_id == own_error::kPathDeviates;
  return stops ? std::optional("it is off its path") : std::nullopt;
}

// --- Ends that are asked for.

void LoadPathRun::cancel(const std::string& why, Instant now) {
  if (state_ == State::Following) stopped_why_ = why + "; no motion was under way";
  fire(Event::Cancel, now);
  endWhenNothingIsLeft(now);
}

void LoadPathRun::interrupt(const std::string& why, Instant now) {
  if (state_ == State::Following) interrupted_ = true;
  cancel(why, now);
}

void LoadPathRun::finish(FinishAfter /*after*/, Instant now) {
  const auto& members = chain_.members();
  for (std::size_t i = 1; i < members.size(); ++i) {
    if (!chain_.isUntouched(i)) continue;
    dropFrom(i, "nothing more is begun behind a finish", now);
    return;
  }
}

void LoadPathRun::linkLost(const std::string& reason, std::optional<Duration> patience, Instant now) {
  if (!chain_.sent().empty() || state_ != State::Following) return;
  failure_ = Failure{motion_error::kLinkDropped, reason, ""};
  if (patience) reason_until_ = now + *patience;
  fire(Event::Unexplained, now);
  if (!patience) fire(Event::Failed, now);
}

void LoadPathRun::robotChanged(const robot::RobotWatch& robot, Instant now) {
  joints_ = robot.jointsDeg();
  pose_ = robot.toolInBaseMmDeg();
  if (speed_ && *speed_ != robot.speedOverride()) progress_.loseClock();
  speed_ = robot.speedOverride();
  progress_.hold(robot.held(), now);
  if (robot.joints()) progress_.see(*robot.joints(), now);
  if (progress_.isUnderWay()) front_end_ = now + progress_.remaining(now);
  checkDeviation(now);
  follow(now);
  const bool waits = chain_.sent().empty() && !outcome();
  if (!waits) return;
  if (robot.emergencyStop() || robot.inError()) {
    failure_ = robot.emergencyStop() ? emergencyStop() : robotError(robot);
    fire(Event::Failed, now);
    endWhenNothingIsLeft(now);
  } else if (state_ == State::Explaining && (!robot.status() || reason_.endsWithFrame(now))) {
    fire(Event::Failed, now);
  }
}

void LoadPathRun::checkDeviation(Instant now) {
  const auto& member = chain_.members()[chain_.memberAt(place_.done)];
  const double most = member.loaded->max_deviation;
  if (state_ != State::Following || most <= 0 || progress_.offThePath() <= most) return;
  fail({own_error::kPathDeviates,
        fmt::format("the moved frame is {:.2f} mm off its path, and {:.2f} mm is allowed",
                    progress_.offThePath() * 1000, most * 1000),
        ""},
       now);
}

// --- Where it is.

void LoadPathRun::done(std::size_t points, Instant now) {
  progress_.done(points);
  follow(now);
  while (!outcome() && chain_.members().front().behind() <= points) {
    if (chain_.members().size() == 1) {
      fire(Event::LastDone, now);
      return;
    }
    const Member& first = chain_.members().front();
    endOne(first.goal, complete(first, Outcome(), now), chain_.members()[1].goal);
    chain_.dropFirst();
  }
}

/// Point by point, though several may have been passed since.
void LoadPathRun::follow(Instant now) {
  const bool stays = state_ != State::Following && !progress_.isUnderWay();  // where it was stopped
  if (outcome() || stays) return;
  const PathChain::Place place = progress_.placeAt(now);
  while (place_.done < place.done) {
    Member& member = chain_.members()[chain_.memberAt(place_.done)];
    member.pointDone(place_.done, now);
    place_.behind_active = std::max(place_.behind_active, ++place_.done + 1);
    if (place_.done < place.done) tell(now);
  }
  place_ = place;
  if (place_.done < place_.behind_active) {
    Member& member = chain_.members()[chain_.memberAt(place_.done)];
    if (!member.began) member.began = now;
  }
  tell(now);
}

void LoadPathRun::tell(Instant now) {
  chain_.passGates(place_, controls_.tracking);
  for (Member& member : chain_.members()) {
    PathPlace told = chain_.placeOf(member, place_);
    told.source = progress_.source();
    if (member.isNews(told, now)) report(member.goal, progressOf(member, told));
  }
}

Progress LoadPathRun::progressOf(const Member& member, const PathPlace& place) const {
  Progress progress;
  const bool begun = place.active || place.done_path_points > 0;
  if (phase_ == Phase::Stopping || begun) {
    progress.phase = phase_;
    progress.text = text_;
  } else if (place.waits_for_tracking) {
    progress.phase = Phase::WaitingForTracking;
    progress.text = textOfGate(controls_.tracking, member.loaded->tracking);
  } else {
    progress.phase = std::min(phase_, Phase::Queued);
    progress.text = "loaded behind what is under way";
  }
  progress.planned = member.loaded->planned;
  const double share = place.active ? progress_.share() : 0;
  progress.fraction = (place.done_path_points + share) / static_cast<double>(member.count());
  progress.remaining = fromSeconds(toSeconds(member.loaded->planned) * (1 - progress.fraction));
  progress.detail = Detail(place);
  return progress;
}

// --- What it is controlled by from outside.

void LoadPathRun::use(const path::PathControls& controls, Instant now) {
  controls_ = controls;
  for (Member& member : chain_.members()) member.told_at.reset();
  tell(now);
}

/// Once the last point in front is under way: what is automatic would be in its way until then.
std::optional<path::TrackingFlags> LoadPathRun::wantedTracking() const {
  const Member* const waits = chain_.firstAtGate();
  if (state_ != State::Following || waits == nullptr || place_.behind_active < waits->first) {
    return std::nullopt;
  }
  return waits->loaded->tracking;
}

// --- Goals that join it.

bool LoadPathRun::isJoinedBy(Block block) const {
  return block == this->block() && state_ == State::Following && chain_.members().size() < kMostGoals;
}

Detail LoadPathRun::chain() const {
  const LoadedPath& last = *chain_.members().back().loaded;
  return Detail(ChainToJoin{chain_.end(), last.execution, last.frames, last.tracking});
}

bool LoadPathRun::join(GoalId goal, const Outcome& planned, Instant now) {
  const auto& report = planned.detail.as<PathReport>();
  if (!report.loaded || report.loaded->behind != chain_.end()) return false;
  chain_.add(goal, report);
  open_end_due_ = false;
  tell(now);
  return true;
}

bool LoadPathRun::takeOut(GoalId goal, const std::string& why, Instant now) {
  const auto member = chain_.memberOf(goal);
  if (!member || *member == 0 || state_ != State::Following || !chain_.isUntouched(*member)) return false;
  dropFrom(*member, why, now);
  return true;
}

void LoadPathRun::dropFrom(std::size_t member, const std::string& why, Instant now) {
  const auto& members = chain_.members();
  const int culprit = members[member].loaded->method_id;
  for (std::size_t i = members.size(); i-- > member;) {
    const std::string text = i == member ? why : fmt::format("load_path {} in front of it: {}", culprit, why);
    endOne(members[i].goal, complete(members[i], commandAborted(text), now), goal());
  }
  chain_.dropFrom(member);
}

std::size_t LoadPathRun::waiting() const {
  std::size_t count = 0;
  for (std::size_t i = 1; i < chain_.members().size(); ++i) count += chain_.isUntouched(i) ? 1 : 0;
  return count;
}

// --- Ends.

void LoadPathRun::fire(Event event, Instant now) {
  const auto row = findTransition<LoadPathTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  switch (row->action) {
    case LoadPathAction::None:
      return;
    case LoadPathAction::AwaitReason:
      reason_.begin(now);
      return;
    case LoadPathAction::EndDone:
      end(complete(chain_.members().front(), Outcome(), now));
      return;
    case LoadPathAction::EndStopped:
      endAll(stoppedOutcomes(chain_, place_, {stopped_why_, interrupted_}), now);
      return;
    case LoadPathAction::EndFailed:
      reason_until_.reset();
      endAll(failedOutcomes(chain_, place_, *failure_), now);
      return;
  }
}

void LoadPathRun::endAll(const std::vector<Outcome>& outcomes, Instant now) {
  const auto& members = chain_.members();
  for (std::size_t i = members.size(); i-- > 1;) {
    endOne(members[i].goal, complete(members[i], outcomes[i], now), goal());
  }
  end(complete(members.front(), outcomes.front(), now));
}

Outcome LoadPathRun::complete(const Member& member, Outcome outcome, Instant now) const {
  outcome = completed(std::move(outcome), member, progress_.deviation(), now);
  outcome.final_joints_deg = joints_;
  outcome.final_pose_mm_deg = pose_;
  return outcome;
}

}  // namespace cobot_command::blocks
