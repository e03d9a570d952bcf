#include "cobot_command/path/driven_path.h"

#include <algorithm>
#include <utility>

#include "pvt/pvt_knots.h"
#include "way_search.h"

#include "cobot_command/motion/command.h"

namespace cobot_command::path {
namespace {

/// So far may it be behind its clock: further is looked for by nobody who has no time for it.
constexpr Duration kFarthestBack = std::chrono::seconds(60);
/// A point that the robot stands on is passed, though it may be as little in front of it.
constexpr Duration kNearly = std::chrono::milliseconds(500);
/// Each side of a cut has a time of its own.
constexpr Duration kCut{1};

std::size_t countOf(const PathPlan& plan) {
  return plan.points().size();
}

}  // namespace

Duration DrivenPath::begin() const {
  return pieces_.empty() ? Duration::zero() : pieces_.front().begin;
}

Duration DrivenPath::end() const {
  return pieces_.empty() ? Duration::zero() : pieces_.back().end();
}

void DrivenPath::send(std::shared_ptr<const PathPlan> plan, std::size_t first) {
  const Duration duration = plan->duration();
  const bool is_behind_a_cut = !pieces_.empty() && pieces_.back().cut;
  pieces_.push_back({std::move(plan), first, end() + (is_behind_a_cut ? kCut : Duration::zero()), duration});
  std::size_t count = 0;
  for (const Piece& piece : pieces_) count += countOf(*piece.plan);
  while (count - countOf(*pieces_.front().plan) >= kMostPoints && pieces_.front().end() <= reached_) {
    count -= countOf(*pieces_.front().plan);
    pieces_.pop_front();
  }
}

void DrivenPath::come(std::size_t point, Duration time) {
  const auto piece = std::find_if(pieces_.rbegin(), pieces_.rend(),
                                  [point](const Piece& one) { return one.first <= point; });
  if (piece == pieces_.rend()) return;
  const auto& points = piece->plan->points();
  const std::size_t own = point - piece->first;
  const Duration inside = own < points.size() ? points[own].start + time : piece->duration;
  const Duration there = piece->begin + std::clamp(inside, Duration::zero(), piece->duration);
  if (there <= reached_) return;
  reached_ = last_ = there;
  stood_.reset();
}

bool DrivenPath::stand(const arm::JointVector& joints) {
  stood_.reset();
  if (pieces_.empty()) return false;
  const bool is_there = isSamePlace(at(reached_).position, joints);
  const WaySpan span{std::max(begin(), reached_ - kFarthestBack), farthest()};
  const auto place = is_there ? std::optional(reached_) : placeBetween(*this, joints, span, reached_);
  if (!place) return false;
  reached_ = last_ = *place;
  stood_ = joints;
  return true;
}

void DrivenPath::cut(const arm::JointVector& joints) {
  if (!stand(joints)) {
    *this = DrivenPath();
    is_cut_short_ = true;
    return;
  }
  while (!pieces_.empty() && pieces_.back().begin >= reached_) pieces_.pop_back();
  if (pieces_.empty()) return;
  pieces_.back().duration = reached_ - pieces_.back().begin;
  pieces_.back().cut = joints;
}

motion::JointState DrivenPath::at(Duration time) const {
  const auto behind = std::upper_bound(pieces_.begin() + 1, pieces_.end(), time,
                                       [](Duration at, const Piece& one) { return at < one.begin; });
  const Piece& piece = *(behind - 1);
  return piece.plan->at(std::min(time - piece.begin, piece.duration));
}

std::vector<DrivenPath::Cut> DrivenPath::cuts() const {
  std::vector<Cut> cuts;
  for (const Piece& piece : pieces_) {
    if (piece.cut) cuts.push_back({piece.end(), *piece.cut});
  }
  return cuts;
}

std::vector<DrivenPath::Knot> DrivenPath::knots(Duration from, Duration until, std::size_t most) const {
  std::vector<Knot> knots;
  for (const Piece& piece : pieces_) {
    if (piece.duration == Duration::zero() || piece.end() <= from || piece.begin >= until) continue;
    for (const PvtKnot& knot : knotsOf(*piece.plan, 0, countOf(*piece.plan) - 1, motion::kLeastSegment)) {
      const Duration time = piece.begin + knot.time;
      if (knot.time > piece.duration || time >= until || knots.size() == most) break;
      if (time > from) knots.push_back({time, leadAt(*piece.plan, knot)});
    }
  }
  return knots;
}

/// A corner is passed in the middle of its overlap.
Duration DrivenPath::passTime(const Piece& piece, std::size_t point) {
  const PlannedPoint& own = piece.plan->points()[point];
  return piece.begin + own.end() - own.overlap / 2;
}

bool DrivenPath::standsAt(const Piece& piece, Duration time) const {
  if (!stood_ || time <= reached_ || time - reached_ > kNearly) return false;
  return isSamePlace(piece.plan->at(time - piece.begin).position, *stood_);
}

/// In their order, with the time at which each was passed.
template <class Take>
void DrivenPath::forEachPassed(const Take& take) const {
  for (const Piece& piece : pieces_) {
    const Duration until = std::min(reached_, piece.end());
    for (std::size_t i = 0; i < countOf(*piece.plan); ++i) {
      const Duration passed = passTime(piece, i);
      if (passed > until && !standsAt(piece, passed)) break;
      take(piece.plan->points()[i], std::min(passed, until));
    }
  }
}

int DrivenPath::firstGoal() const {
  return pieces_.front().plan->points().front().goal;
}

int DrivenPath::lastGoal() const {
  const auto piece = std::find_if(pieces_.rbegin(), pieces_.rend(),
                                  [this](const Piece& one) { return one.begin < reached_; });
  return piece->plan->points()[piece->plan->placeAt(reached_ - piece->begin).point].goal;
}

std::optional<Duration> DrivenPath::passed(int goal, int index) const {
  std::optional<Duration> found;
  forEachPassed([&](const PlannedPoint& point, Duration when) {
    if (point.goal == goal && point.index == index) found = when;
  });
  return found;
}

std::optional<Duration> DrivenPath::beginOf(int goal) const {
  if (pieces_.empty()) return std::nullopt;
  const Piece& first = pieces_.front();
  const bool is_first = first.plan->points().front().goal == goal;
  const bool is_its_begin = first.first == 0 && !is_cut_short_;
  if (is_first) return is_its_begin ? std::optional(first.begin) : std::nullopt;
  std::optional<Duration> found;
  std::optional<Duration> before;
  forEachPassed([&](const PlannedPoint& point, Duration when) {
    if (point.goal == goal && !found) found = before;
    before = when;
  });
  const bool is_last = !found && !isEmpty() && lastGoal() == goal;
  return is_last ? before : found;
}

std::optional<DrivenPath::Range> DrivenPath::passedOf(int goal) const {
  std::optional<Range> range;
  forEachPassed([&](const PlannedPoint& point, Duration /*when*/) {
    if (point.goal != goal) return;
    if (!range) range = Range{point.index, point.index};
    range->last = point.index;
  });
  return range;
}

}  // namespace cobot_command::path
