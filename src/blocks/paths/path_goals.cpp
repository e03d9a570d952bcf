#include "paths/path_goals.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "paths/path_outcomes.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/units.h"

namespace cobot_command::blocks {
namespace {

/// So many goals may one chain have at a time.
constexpr std::size_t kMostGoals = 64;

/// The feedrate of what the controller has first.
std::optional<double> running(const PathChain& chain) {
  if (chain.sent().empty()) return std::nullopt;
  return chain.sent().front().piece->plan.points().front().feedrate;
}

/// "tracking object 0 to be on": of those that are not as they should be.
std::string textOfGate(const path::TrackingObjects& objects, const path::TrackingFlags& wanted) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < path::kTrackingObjects; ++i) {
    if (objects[i].on == wanted[i]) continue;
    texts.push_back(fmt::format("tracking object {} to be {}", i, wanted[i] ? "on" : "off"));
  }
  return fmt::format("waits for {}", fmt::join(texts, " and "));
}

/// What the first goal that waits at its gate waits for; empty: none does.
std::string gateText(const PathChain& chain, const PathChain::Place& place,
                     const path::TrackingObjects& objects) {
  const PathChain::Member* const at_gate = chain.firstAtGate();
  if (at_gate == nullptr || !chain.placeOf(*at_gate, place).waits_for_tracking) return "";
  return fmt::format("after load_path {}, which {}", at_gate->loaded->method_id,
                     textOfGate(objects, at_gate->loaded->tracking));
}

/// Of a goal whose points do not move the robot yet, and that nothing holds back but its place in the chain.
std::string textOfPlace(const PathChain& chain, const PathChain::Member& member, const PathPlace& place,
                        const std::string& at_gate) {
  if (!member.passed_gate && !at_gate.empty()) return at_gate;
  if (chain.sent().empty()) return "waits for a goal that it may blend into";
  const bool has_a_place = place.pending_path_points < static_cast<int>(member.count());
  return has_a_place ? "loaded after the running points" : "waits for room after the running points";
}

/// The points up to there are of goals whose ends have no tag, as a PVT has few, and were shown to be passed.
std::size_t untaggedEnds(const PathChain& chain, std::size_t shown) {
  std::size_t points = 0;
  for (const PathChain::Member& member : chain.members()) {
    if (member.behind() > shown || chain.sent().front().isMarked(member.behind() - 1)) break;
    points = member.behind();
  }
  return points;
}

void tellControls(PathStatus& status, const PathChain& chain, const PathChain::Place& place,
                  const path::PathControls& controls) {
  status.feedrate = kPercent * controls.asked();
  status.feedrate_effective = kPercent * controls.effective(running(chain));
  const PathChain::Member* const at_gate = chain.firstAtGate();
  status.gate_waits = at_gate != nullptr && chain.placeOf(*at_gate, place).waits_for_tracking;
}

}  // namespace

PathGoals::PathGoals(RunReports& reports, GoalId first, const PathReport& planned)
    : reports_(reports), chain_(first, planned), progress_(planned.loaded->end->scene().arm) {}

// --- Goals that join.

bool PathGoals::isJoinedBy(Block block) const {
  return block == kBlock<LoadPathGoal> && chain_.members().size() < kMostGoals && !chain_.isRewound();
}

Detail PathGoals::end() const {
  const LoadedPath& last = *chain_.members().back().loaded;
  return Detail(ChainToJoin{chain_.end(), last.execution, last.frames, last.tracking});
}

bool PathGoals::join(GoalId goal, const Outcome& planned, Instant now) {
  const auto& report = planned.detail.as<PathReport>();
  if (!report.loaded || report.loaded->behind != chain_.end()) return false;
  chain_.add(goal, report);
  replan_.goalsChanged();
  tell(now);
  return true;
}

bool PathGoals::takeOut(GoalId goal, const std::string& why, Instant now) {
  const auto member = chain_.memberOf(goal);
  if (!member || *member == 0 || !chain_.isUntouched(*member)) return false;
  dropFrom(*member, why, now);
  return true;
}

std::size_t PathGoals::waiting() const {
  std::size_t count = 0;
  for (std::size_t i = 1; i < chain_.members().size(); ++i) count += chain_.isUntouched(i) ? 1 : 0;
  return count;
}

// --- What becomes of the pieces.

void PathGoals::progressed(const Progress& progress, Instant now) {
  if (phase_ != progress.phase) chain_.tellAnew();
  phase_ = progress.phase;
  text_ = progress.text;
  holdProgress(now);
  const Duration duration = chain_.sent().front().piece->plan.duration();
  if (progress.planned && *progress.planned > Duration::zero() && duration > Duration::zero()) {
    rate_ = toSeconds(duration) / toSeconds(*progress.planned);
  }
  if (phase_ == Phase::Active && !progress_.isUnderWay()) begin(now);
  follow(now);
}

/// Where the arm comes to rest, and how, is no deviation.
void PathGoals::holdProgress(Instant now) {
  progress_.hold(is_held_ || controls_.held || phase_ == Phase::Stopping, now);
}

void PathGoals::begin(Instant now) {
  progress_.begin(chain_.sent().front(), rate_, now);
  piece_end_ = now + progress_.remaining(now);
  status_clock_.begin(now);
}

std::optional<PathStand> PathGoals::pieceEnded(Instant now) {
  const std::optional<PathStand> stand = progress_.standAt(now);
  progress_.end();
  piece_end_.reset();
  return stand;
}

bool PathGoals::done(std::size_t points, Instant now) {
  progress_.done(points);
  follow(now);
  return endUpTo(points, now);
}

bool PathGoals::endUpTo(std::size_t points, Instant now) {
  while (chain_.members().front().behind() <= points) {
    if (chain_.members().size() == 1) return true;
    const Member& first = chain_.members().front();
    reports_.end(first.goal, complete(first, Outcome(), now), chain_.members()[1].goal);
    chain_.dropFirst();
    replan_.goalsChanged();
  }
  return false;
}

std::optional<PathStand> PathGoals::takeBack(CommandKey key, Instant now) {
  std::optional<PathStand> stand;
  if (progress_.isUnderWay() && chain_.sent().isFirst(key)) stand = stand_ = pieceEnded(now);
  chain_.sent().takeBack(key);
  return stand;
}

void PathGoals::rewind(const arm::JointVector& joints, Instant now) {
  const PathStand seen = std::exchange(stand_, std::nullopt).value_or(PathStand{place_.done, {}});
  const PathStand stand = standOn(chain_.sent().takenBack(), seen, joints);
  phase_ = Phase::Queued;
  text_.clear();
  const bool is_over = done(stand.point, now);
  assert(!is_over);
  static_cast<void>(is_over);
  chain_.rewind(stand.point, stand.time, joints);
  chain_.tellAnew();
  tell(now);
}

void PathGoals::robotChanged(const robot::RobotWatch& robot, Instant now) {
  joints_ = robot.jointsDeg();
  pose_ = robot.toolInBaseMmDeg();
  if (speed_ && *speed_ != robot.speedOverride()) progress_.loseClock();
  speed_ = robot.speedOverride();
  is_held_ = robot.held();
  holdProgress(now);
  if (robot.joints()) progress_.see(*robot.joints(), now);
  if (progress_.isUnderWay()) piece_end_ = now + progress_.remaining(now);
  follow(now);
  const bool is_over = endUpTo(untaggedEnds(chain_, progress_.shown()), now);
  assert(!is_over);
  static_cast<void>(is_over);
}

void PathGoals::use(const path::PathControls& controls, Instant now) {
  if (controls == controls_) return;
  controls_ = controls;
  replan_.ask(controls.feedrate);
  holdProgress(now);
  chain_.tellAnew();
  tell(now);
}

/// Point by point, though several may have been passed since.
void PathGoals::follow(Instant now) {
  if (stays_ && !progress_.isUnderWay()) return;
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

void PathGoals::tell(Instant now) {
  chain_.passGates(place_, controls_.tracking);
  for (Member& member : chain_.members()) {
    PathPlace told = chain_.placeOf(member, place_);
    told.source = progress_.source();
    if (member.isNews(told, now)) reports_.tell(member.goal, progressOf(member, told));
  }
}

void PathGoals::tellPhase(Progress& progress, const Member& member, const PathPlace& place) const {
  const bool begun = place.active || place.done_path_points > 0;
  const bool waits = chain_.sent().empty() && !place.waits_for_tracking;
  const bool is_stopped = controls_.held || (controls_.stopped && waits);
  if (is_stopped && phase_ != Phase::Stopping) {
    progress.phase = Phase::Held;
    progress.text = begun ? "stopped on its path: resume_path, or a feedrate above 0, continues it"
                          : "paths are stopped: resume_path, or a feedrate above 0, starts it";
  } else if (chain_.sent().empty() && phase_ != Phase::Stopping && !replan_.isServed()) {
    progress.phase = Phase::Held;
    progress.text = replan_.text();
  } else if (phase_ == Phase::Stopping || begun) {
    progress.phase = phase_;
    progress.text = text_;
  } else if (place.waits_for_tracking) {
    progress.phase = Phase::WaitingForTracking;
    progress.text = textOfGate(controls_.tracking, member.loaded->tracking);
  } else {
    progress.phase = std::min(phase_, Phase::Queued);
    progress.text = textOfPlace(chain_, member, place, gateText(chain_, place_, controls_.tracking));
  }
}

Progress PathGoals::progressOf(const Member& member, const PathPlace& place) const {
  Progress progress;
  tellPhase(progress, member, place);
  progress.planned = member.loaded->planned;
  const double share = place.active ? progress_.share() : 0;
  progress.fraction = (place.done_path_points + share) / static_cast<double>(member.count());
  progress.remaining = fromSeconds(toSeconds(member.loaded->planned) * (1 - progress.fraction));
  progress.detail = Detail(place);
  return progress;
}

// --- What everyone is told of it.

void PathGoals::tellStatus(Instant now) {
  if (!status_clock_.takeDue(now)) return;
  follow(now);
  PathStatus status = statusOf(chain_, place_, progress_, now);
  tellControls(status, chain_, place_, controls_);
  reports_.tellEveryone(Detail(status));
}

void PathGoals::endStatus() {
  if (!status_clock_.end()) return;
  PathStatus status;
  tellControls(status, chain_, place_, controls_);
  reports_.tellEveryone(Detail(status));
}

// --- What is known.

std::optional<Failure> PathGoals::deviation() const {
  const Member& member = chain_.members()[chain_.memberAt(place_.done)];
  const double most = member.loaded->max_deviation;
  if (most <= 0 || progress_.offThePath() <= most) return std::nullopt;
  return Failure{own_error::kPathDeviates,
                 fmt::format("the moved frame is {:.6g} mm off its path; allowed: {:.6g} mm",
                             progress_.offThePath() * 1000, most * 1000),
                 ""};
}

PathPace PathGoals::pace() const {
  PathPace pace;
  pace.running = running(chain_);
  if (const LoadedPiecePtr next = chain_.next()) pace.next_point = next->plan.points().front().index;
  const Member& active = chain_.members()[chain_.memberAt(place_.done)];
  pace.active_point = active.loaded->start_index + static_cast<int>(place_.done - active.first);
  pace.highest = chain_.highestFeedrate(false);
  pace.highest_of_all = chain_.highestFeedrate(true);
  return pace;
}

bool PathGoals::mayGoOn() const {
  return !controls_.stopped && !chain_.isNextAtGate() && replan_.isServed();
}

// --- Ends.

void PathGoals::dropUntouched(const std::string& why, Instant now) {
  const std::size_t untouched = chain_.members().size() - waiting();
  if (untouched < chain_.members().size()) dropFrom(untouched, why, now);
}

/// Of the goals from that one on nothing was sent.
void PathGoals::dropFrom(std::size_t member, const std::string& why, Instant now) {
  const auto& members = chain_.members();
  const int culprit = members[member].loaded->method_id;
  for (std::size_t i = members.size(); i-- > member;) {
    const std::string text = i == member ? why : fmt::format("load_path {} before it: {}", culprit, why);
    reports_.end(members[i].goal, complete(members[i], commandAborted(text), now), reports_.goal());
  }
  chain_.dropFrom(member);
  replan_.goalsChanged();
}

Outcome PathGoals::endAll(const std::vector<Outcome>& outcomes, Instant now) {
  const auto& members = chain_.members();
  for (std::size_t i = members.size(); i-- > 1;) {
    reports_.end(members[i].goal, complete(members[i], outcomes[i], now), reports_.goal());
  }
  return complete(members.front(), outcomes.front(), now);
}

Outcome PathGoals::complete(const Member& member, Outcome outcome, Instant now) const {
  outcome = completed(std::move(outcome), member, progress_.deviation(), now);
  if (!outcome.final_joints_deg) outcome.final_joints_deg = joints_;
  if (!outcome.final_pose_mm_deg) outcome.final_pose_mm_deg = pose_;
  return outcome;
}

}  // namespace cobot_command::blocks
