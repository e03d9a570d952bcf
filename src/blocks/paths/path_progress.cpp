#include "paths/path_progress.h"

#include <algorithm>

namespace cobot_command::blocks {
namespace {

path::Deviation largest(const path::Deviation& a, const path::Deviation& b) {
  return {std::max(a.joint, b.joint), std::max(a.path, b.path), std::max(a.lag, b.lag)};
}

}  // namespace

void PathProgress::begin(const PathChain::Sent& sent, double rate, Instant now) {
  end();
  follower_.emplace(arm_, sent.piece, rate, now);
  if (!has_clock_) follower_->loseClock();
  piece_ = sent.piece;
  first_ = sent.first;
  rate_ = rate;
}

void PathProgress::hold(bool held, Instant now) {
  is_held_ = held;
  if (!follower_) return;
  if (held) {
    follower_->hold(now);
  } else {
    follower_->letGo(now);
  }
}

void PathProgress::loseClock() {
  has_clock_ = false;
  if (follower_) follower_->loseClock();
}

void PathProgress::see(const arm::JointVector& joints, Instant now) {
  if (follower_) follower_->see(joints, now);
}

void PathProgress::done(std::size_t points) {
  done_ = std::max(done_, points);
  if (follower_ && points > first_) follower_->pass(points - 1 - first_);
}

void PathProgress::end() {
  if (!follower_) return;
  ended_ = deviation();
  follower_.reset();
  share_ = 0;
}

PathChain::Place PathProgress::placeAt(Instant now) {
  if (!follower_) return {done_, done_};
  const auto place = follower_->placeAt(follower_->time(now));
  const bool is_ahead = first_ + place.point >= done_;
  done_ = std::max(done_, first_ + place.point);
  share_ = is_ahead ? place.share : 0;
  return {done_, done_ + (is_ahead && place.blends ? 2 : 1)};
}

std::size_t PathProgress::shown() const {
  const auto time = follower_ ? follower_->shown() : std::nullopt;
  return time ? first_ + follower_->placeAt(*time).point : 0;
}

std::optional<PathProgress::Motion> PathProgress::motion(Instant now) const {
  if (!follower_) return std::nullopt;
  return Motion{piece_, first_, follower_->time(now), is_held_ ? 0.0 : rate_};
}

std::optional<PathStand> PathProgress::standAt(Instant now) const {
  if (!follower_) return std::nullopt;
  const PathStand seen = blocks::standAt(*piece_, first_, follower_->time(now));
  return seen.point < done_ ? PathStand{done_, {}} : seen;
}

ProgressSource PathProgress::source() const {
  return follower_ ? follower_->source() : ProgressSource::Tag;
}

Duration PathProgress::remaining(Instant now) const {
  return follower_ ? follower_->remaining(now) : Duration::zero();
}

path::Deviation PathProgress::deviation() const {
  return follower_ ? largest(ended_, follower_->deviation()) : ended_;
}

}  // namespace cobot_command::blocks
