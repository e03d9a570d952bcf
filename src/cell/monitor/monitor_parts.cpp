#include "monitor/monitor_parts.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using monitor::MechanismTrack;
using monitor::Names;
using monitor::PairWatch;
using monitor::RobotTrack;
using monitor::Threshold;
using monitor::Track;

/// Older records of breaches are dropped for newer ones.
constexpr std::size_t kMostBreaches = 1000;

}  // namespace

Monitor::Parts::Parts(std::vector<WatchedRobot> robots, const std::vector<WatchedObstacle>& obstacles,
                      const MonitorSettings& settings, std::vector<WatchedMechanism> mechanisms)
    : settings_(settings),
      stop_distance_(settings.stop_distance.value_or(settings.margin / 2)),
      alarm_(settings.mode) {
  for (WatchedRobot& robot : robots) {
    auto track = std::make_unique<RobotTrack>(robot.bodies, std::move(robot.may_carry), robot.most_speeds);
    robots_[robot.name] = track.get();
    movers_.push_back({robot.name, std::move(track)});
  }
  for (WatchedMechanism& mechanism : mechanisms) {
    auto track = std::make_unique<MechanismTrack>(mechanism.name, std::move(mechanism.bodies));
    mechanisms_[mechanism.name] = track.get();
    movers_.push_back({mechanism.name, std::move(track)});
  }
  for (const WatchedObstacle& obstacle : obstacles) {
    obstacles_.push_back({obstacle.name, {}});
    obstacles_.back().set = monitor::fixedSet(obstacle.capsules);
  }
  pairUp(robots.size());
}

void Monitor::Parts::pairUp(std::size_t robots) {
  for (std::size_t first = 0; first < movers_.size(); ++first) {
    // A mechanism has one way only, and all of that was proved to be far enough from obstacles.
    const std::size_t end = movers_.size() + (first < robots ? obstacles_.size() : 0);
    for (std::size_t second = first + 1; second < end; ++second) {
      PairWatch pair;
      pair.first = first;
      pair.second = second;
      pairs_.push_back(pair);
    }
  }
}

void Monitor::Parts::take(const std::string& robot, const arm::JointVector& joints,
                          const std::optional<arm::JointVector>& velocities, Duration age, Instant now) {
  const auto found = robots_.find(robot);
  if (found == robots_.end()) {
    ++counts_.unknown;
    return;
  }
  count(found->second->take(joints, velocities, age, now, settings_.stale_after), now);
}

void Monitor::Parts::takePosition(const std::string& mechanism, double position, Duration age, Instant now) {
  const auto found = mechanisms_.find(mechanism);
  if (found == mechanisms_.end()) {
    ++counts_.unknown;
    return;
  }
  count(found->second->take(position, age, now, settings_.stale_after), now);
}

void Monitor::Parts::count(Track::Taken taken, Instant now) {
  switch (taken) {
    case Track::Taken::Malformed:
      ++counts_.malformed;
      break;
    case Track::Taken::Old:
      ++counts_.old;
      break;
    case Track::Taken::Yes:
      if (!news_) news_ = now;
      break;
  }
}

bool Monitor::Parts::setCarried(const std::string& robot, const std::optional<Carried>& parts) {
  const auto found = robots_.find(robot);
  if (found == robots_.end()) return false;
  RobotTrack& track = *found->second;
  if (parts == track.carried()) return true;
  if (!track.carry(parts)) return false;
  if (!news_) news_ = ticked_;
  return true;
}

bool Monitor::Parts::setPermit(const std::string& mover, const std::optional<Permit>& permit) {
  const auto found =
      std::find_if(movers_.begin(), movers_.end(), [&](const Mover& one) { return one.name == mover; });
  if (found == movers_.end()) return false;
  found->permit = permit;
  return true;
}

void Monitor::Parts::tick(Instant now) {
  bool one_moves = false;
  for (Mover& mover : movers_) {
    if (!mover.track->heard()) continue;
    judgeAge(mover, now);
    grow(mover, now);
    one_moves = one_moves || (!mover.silent && mover.track->moves(settings_.standing_speed));
  }
  for (PairWatch& pair : pairs_) judge(pair, now);
  if (one_moves) alarm_.moving(now);
  ticked_ = now;
  news_.reset();
}

void Monitor::Parts::judgeAge(Mover& mover, Instant now) {
  const bool was_silent = mover.silent;
  mover.silent =
      mover.track->age(now) > settings_.stale_after && mover.track->moves(settings_.standing_speed);
  if (mover.silent && !was_silent) alarm_.raise(staleSentence(mover), now);
}

void Monitor::Parts::grow(Mover& mover, Instant now) {
  // What is older says nothing of one that moved, which stops all anyway, and one that stood would in the end
  // be anywhere by the last digits of its speeds.
  mover.track->grow(std::min(mover.track->age(now), settings_.stale_after));
}

void Monitor::Parts::growPromptly(Mover& mover, Instant now) {
  mover.track->grow(std::min(mover.track->age(now), settings_.prompt), mover.permit->most_speeds);
}

bool Monitor::Parts::areKeptApart(const PairWatch& pair) const {
  const auto& first = movers_[pair.first].permit;
  if (!first) return false;
  if (pair.second >= movers_.size()) return true;  // an obstacle
  const auto& second = movers_[pair.second].permit;
  if (!second) return false;
  std::vector<std::size_t> both;
  std::set_intersection(first->holds.begin(), first->holds.end(), second->holds.begin(), second->holds.end(),
                        std::back_inserter(both));
  return both.empty();
}

void Monitor::Parts::boundByPermits(PairWatch& pair, Instant now) {
  std::vector<Mover*> movers{&movers_[pair.first]};
  if (pair.second < movers_.size()) movers.push_back(&movers_[pair.second]);
  for (Mover* mover : movers) growPromptly(*mover, now);
  const monitor::Gap prompt =
      gapBetween(setOf(pair.first), setOf(pair.second), settings_.exact_within, pair.gap);
  for (Mover* mover : movers) grow(*mover, now);
  pair.gap.lowest = std::max(pair.gap.lowest, std::min(prompt.lowest, settings_.margin));
}

void Monitor::Parts::judge(PairWatch& pair, Instant now) {
  pair.known = isHeard(pair.first) && isHeard(pair.second);
  if (!pair.known) return;
  pair.gap = gapBetween(setOf(pair.first), setOf(pair.second), settings_.exact_within, pair.gap);
  if (pair.gap.lowest < settings_.margin && areKeptApart(pair)) boundByPermits(pair, now);
  // At once, as what one carries may change before anybody asks.
  pair.bodies = bodiesOf(pair);
  if (pair.gap.distance < pair.least) pair.keepLeast(now);
  const Threshold::Passed margin = pair.margin.see(pair.gap.lowest, settings_.margin);
  if (margin == Threshold::Passed::Down) begin(pair, now);
  if (margin == Threshold::Passed::Up) end(pair, now);
  if (pair.breach) pair.keepBreach(now);
  if (pair.stop.see(pair.gap.lowest, stop_distance_) == Threshold::Passed::Down) {
    alarm_.raise(sentenceOf(pair, stop_distance_, "stop distance"), now);
  }
}

void Monitor::Parts::begin(PairWatch& pair, Instant now) {
  Breach breach;
  breach.first = nameOf(pair.first);
  breach.second = nameOf(pair.second);
  breach.first_body = pair.bodies.first;
  breach.second_body = pair.bodies.second;
  breach.start = now;
  breach.least = pair.gap.lowest;
  breach.distance = pair.gap.distance;
  breach.least_at = now;
  pair.breach = breach;
  alarm_.warn(sentenceOf(pair, settings_.margin, "margin"));
}

void Monitor::Parts::end(PairWatch& pair, Instant now) {
  pair.breach->end = now;
  alarm_.ended(*pair.breach);
  ended_.push_back(std::move(*pair.breach));
  pair.breach.reset();
  if (ended_.size() <= kMostBreaches) return;
  ended_.pop_front();
  ++counts_.lost_breaches;
}

ResetAnswer Monitor::Parts::reset(Instant now) {
  tick(now);
  const std::vector<std::string> reasons = causes();
  if (!latched()) return {true, "Nothing was stopped, so there is nothing to reset."};
  if (!reasons.empty()) {
    return {false, "The monitor cannot be reset while the cause persists. " + reasons.front()};
  }
  alarm_.reset();
  return {true, "The monitor is reset, and all may move again."};
}

std::vector<Breach> Monitor::Parts::breaches() const {
  std::vector<Breach> all(ended_.begin(), ended_.end());
  for (const PairWatch& pair : pairs_) {
    if (pair.breach) all.push_back(*pair.breach);
  }
  return all;
}

std::optional<Instant> Monitor::Parts::nextDeadline() const {
  if (!ticked_) return news_;
  std::optional<Instant> next;
  if (news_) next = *ticked_ + settings_.period;
  for (const Mover& mover : movers_) {
    // Of one that moved and fell silent nothing changes any more but that it is heard again.
    if (mover.silent || !mover.track->moves(settings_.standing_speed)) continue;
    const Instant stale = mover.track->measured() + settings_.stale_after + Duration(1);
    const Instant due = std::min(*ticked_ + settings_.period, std::max(stale, *ticked_));
    if (!next || due < *next) next = due;
  }
  return next;
}

const monitor::BodySet& Monitor::Parts::setOf(std::size_t thing) const {
  return thing < movers_.size() ? movers_[thing].track->set() : obstacles_[thing - movers_.size()].set;
}

const std::string& Monitor::Parts::nameOf(std::size_t thing) const {
  return thing < movers_.size() ? movers_[thing].name : obstacles_[thing - movers_.size()].name;
}

bool Monitor::Parts::isHeard(std::size_t thing) const {
  return thing >= movers_.size() || movers_[thing].track->heard();
}

}  // namespace cobot_command::cell
