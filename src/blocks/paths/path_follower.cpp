#include "paths/path_follower.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cobot_command/path/driven_path.h"

namespace cobot_command::blocks {
namespace {

/// The stream tells of an arm that may be so far behind the clock, or a little in front of it.
constexpr Duration kBehind = std::chrono::milliseconds(500);
constexpr Duration kInFront = std::chrono::milliseconds(50);
/// On its way into a hold, and out of it.
constexpr Duration kInHold = std::chrono::milliseconds(500);
constexpr Duration kStep = std::chrono::milliseconds(5);
/// No arm begins in front of its plan: then the clock was begun late, as it was heard late of the begin.
constexpr Duration kBegin = std::chrono::milliseconds(500);
constexpr Duration kLate = 2 * kStep;

}  // namespace

PathFollower::PathFollower(const arm::ArmModel& arm, LoadedPiecePtr piece, double rate, Instant now)
    : piece_(std::move(piece)), watch_(arm, piece_->plan), clock_(rate, now) {}

void PathFollower::hold(Instant now) {
  clock_.hold(now);
}

void PathFollower::letGo(Instant now) {
  if (!clock_.letGo(now)) return;
  setClock(now);
  picks_up_until_ = now + kInHold;
}

void PathFollower::setClock(Instant now) {
  if (source_ == ProgressSource::Stream) clock_.setTime(*seen_, now);
}

void PathFollower::pass(std::size_t point) {
  const path::PlannedPoint& passed = piece_->plan.points()[point];
  seen_ = std::max(seen_.value_or(Duration::zero()), passed.end());
  source_ = ProgressSource::Tag;
}

void PathFollower::see(const arm::JointVector& joints, Instant now) {
  const bool is_steady = !clock_.isHeld() && !picks_up_until_ && piece_->is_exact && has_clock_;
  if (is_steady) catchUp(joints, now);
  const Duration clock = clock_.time(now);
  if (is_steady) watch_.add(clock, joints);
  const Duration least = has_clock_ ? clock - kBehind : Duration::zero();
  const Duration from = std::max(seen_.value_or(Duration::zero()), least);
  const Duration until = std::min(clock + (is_steady ? kInFront : kInHold), piece_->plan.duration());
  seen_ = from < until ? nearest(joints, from, until) : from;
  source_ = ProgressSource::Stream;
  if (isThere(joints)) shown_ = seen_;
  if (!has_clock_) setClock(now);
  if (picks_up_until_ && now >= *picks_up_until_) {
    picks_up_until_.reset();
    setClock(now);
  }
}

/// Where the clock has gone on without the arm, the nearest place is far from it.
bool PathFollower::isThere(const arm::JointVector& joints) const {
  const motion::JointState there = piece_->plan.at(*seen_);
  const double within_a_step = there.velocity.cwiseAbs().maxCoeff() * toSeconds(kStep);
  return (there.position - joints).cwiseAbs().maxCoeff() <= path::DrivenPath::kSamePlace + within_a_step;
}

void PathFollower::catchUp(const arm::JointVector& joints, Instant now) {
  const Duration clock = clock_.time(now);
  if (clock > kBegin) return;
  const Duration late = nearest(joints, clock, std::min(clock + kBegin, piece_->plan.duration())) - clock;
  if (late > kLate) clock_.advance(late);
}

Duration PathFollower::nearest(const arm::JointVector& joints, Duration from, Duration until) const {
  Duration best = from;
  double least = std::numeric_limits<double>::infinity();
  for (Duration time = from; time <= until; time += kStep) {
    const double gap = (piece_->plan.at(time).position - joints).cwiseAbs().maxCoeff();
    if (gap >= least) continue;
    least = gap;
    best = time;
  }
  return best;
}

Duration PathFollower::time(Instant now) const {
  const Duration seen = seen_.value_or(Duration::zero());
  const Duration found = source_ == ProgressSource::Stream ? seen : std::max(clock_.time(now), seen);
  return std::clamp(found, Duration::zero(), piece_->plan.duration());
}

Duration PathFollower::remaining(Instant now) const {
  return clock_.byController(std::max(Duration::zero(), piece_->plan.duration() - clock_.time(now)));
}

}  // namespace cobot_command::blocks
