#include "paths/path_chain.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <tuple>
#include <utility>

namespace cobot_command::blocks {
namespace {

/// How far it is on its way is told so often, as long as nothing else changes.
constexpr Duration kTellEvery = std::chrono::milliseconds(100);

auto asTuple(const PathPlace& p) {
  return std::tie(p.waits_for_tracking, p.loaded, p.active, p.active_path_point, p.pending_path_points,
                  p.queued_path_points, p.done_path_points);
}

}  // namespace

void PathChain::Member::pointDone(std::size_t point, Instant now) {
  if (began) report.points[point - first].done = now - *began;
}

bool PathChain::Member::isNews(const PathPlace& place, Instant now) {
  const bool is_other = !told_at || asTuple(place) != asTuple(told);
  const bool is_due = place.active && told_at && now - *told_at >= kTellEvery;
  if (!is_other && !is_due) return false;
  told = place;
  told_at = now;
  return true;
}

void PathChain::add(GoalId goal, const PathReport& planned) {
  assert(members_.empty() || planned.loaded->behind == end());
  const std::size_t first = members_.empty() ? 0 : members_.back().behind();
  Member member;
  member.goal = goal;
  member.first = first;
  member.loaded = planned.loaded;
  member.report = planned;
  member.report.loaded = nullptr;
  member.report.preview = nullptr;
  member.report.method_id = planned.loaded->method_id;
  member.report.blends_lost.clear();
  members_.push_back(std::move(member));
  open_end_due_ = false;
  ++next_key_;
  advance();
}

ChainEnd PathChain::end() const {
  const LoadedPath& last = *members_.back().loaded;
  return isOpenEndSent() ? last.closed_end : last.end;
}

bool PathChain::isOpenEndSent() const {
  return open_end_sent_ && cursor_.member + 1 == members_.size();
}

std::optional<std::size_t> PathChain::memberOf(GoalId goal) const {
  const auto found =
      std::find_if(members_.begin(), members_.end(), [goal](const Member& m) { return m.goal == goal; });
  if (found == members_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - members_.begin());
}

std::size_t PathChain::memberAt(std::size_t point) const {
  const auto found =
      std::find_if(members_.begin(), members_.end(), [point](const Member& m) { return point < m.behind(); });
  return static_cast<std::size_t>(std::min(found, members_.end() - 1) - members_.begin());
}

std::size_t PathChain::bufferOf(const Member& member) {
  return static_cast<std::size_t>(member.loaded->settings.buffer);
}

/// What blends with the one in front goes along with that. Of one that is in front of its turn nobody knows
/// yet what its gate will be.
void PathChain::passGates(const Place& place, const path::TrackingObjects& objects) {
  for (std::size_t i = 0; i < members_.size(); ++i) {
    Member& member = members_[i];
    const bool goes_along = i > 0 && member.loaded->first > 0 && members_[i - 1].passed_gate;
    const bool has_place = member.first < place.behind_active + bufferOf(member);
    const bool is_next = member.first <= sent_points_;
    const bool passes =
        goes_along || ((has_place || is_next) && isGateOpen(objects, member.loaded->tracking));
    member.passed_gate = member.passed_gate || passes;
    if (!member.passed_gate) return;
  }
}

const PathChain::Member* PathChain::firstAtGate() const {
  const auto found =
      std::find_if(members_.begin(), members_.end(), [](const Member& m) { return !m.passed_gate; });
  return found == members_.end() ? nullptr : &*found;
}

void PathChain::tellAnew() {
  for (Member& member : members_) {
    if (member.first < sent_points_) member.told_at.reset();
  }
}

bool PathChain::isUntouched(std::size_t member) const {
  return sent_points_ <= members_[member].first;
}

void PathChain::dropFrom(std::size_t member) {
  assert(member > 0 && isUntouched(member));
  members_.erase(members_.begin() + static_cast<std::ptrdiff_t>(member), members_.end());
  ++next_key_;
  if (cursor_.member < member) return;
  cursor_ = {member - 1, members_.back().loaded->pieces.size()};
  open_end_sent_ = sent_points_ >= members_.back().behind();
}

void PathChain::dropFirst() {
  assert(members_.size() > 1 && cursor_.member > 0);
  members_.pop_front();
  --cursor_.member;
}

/// The next member begins at rest: the open end of this one goes out in front of it.
bool PathChain::isOpenEndOwed() const {
  const LoadedPath& next = *members_[cursor_.member + 1].loaded;
  return next.from_rest && members_[cursor_.member].loaded->open_end && !open_end_sent_;
}

/// Past the end of a member to the next one: what its open end has, that one's first piece begins with.
void PathChain::advance() {
  while (cursor_.piece == members_[cursor_.member].loaded->pieces.size() &&
         cursor_.member + 1 < members_.size() && !isOpenEndOwed()) {
    cursor_ = {cursor_.member + 1, 0};
    open_end_sent_ = false;
  }
}

const LoadedPath* PathChain::nextOf() const {
  return next() ? members_[cursor_.member].loaded.get() : nullptr;
}

Order PathChain::restoring() const {
  for (const Member& member : members_) {
    const bool is_begun = member.first < sent_points_;
    if (is_begun && !member.loaded->restoring.lines.empty()) return member.loaded->restoring;
  }
  return {};
}

LoadedPiecePtr PathChain::next() const {
  const LoadedPath& loaded = *members_[cursor_.member].loaded;
  if (cursor_.piece < loaded.pieces.size()) return loaded.pieces[cursor_.piece];
  return open_end_sent_ ? nullptr : loaded.open_end;
}

bool PathChain::isNextOpen() const {
  const LoadedPath& loaded = *members_[cursor_.member].loaded;
  const bool is_last = cursor_.member + 1 == members_.size();
  return is_last && !open_end_due_ && cursor_.piece == loaded.pieces.size() && loaded.open_end &&
         !open_end_sent_;
}

void PathChain::sendNext() {
  const bool is_open = cursor_.piece == members_[cursor_.member].loaded->pieces.size();
  sent_.push_back({next_key_++, next(), sent_points_});
  tellLostBlends(sent_.back());
  sent_points_ = sent_.back().behind();
  open_end_due_ = false;
  if (is_open) {
    open_end_sent_ = true;
  } else {
    ++cursor_.piece;
  }
  advance();
}

bool PathChain::isSent(CommandKey key) const {
  return std::any_of(sent_.begin(), sent_.end(), [key](const Sent& sent) { return sent.key == key; });
}

PathChain::Sent PathChain::take(CommandKey key) {
  const auto found =
      std::find_if(sent_.begin(), sent_.end(), [key](const Sent& sent) { return sent.key == key; });
  Sent taken = *found;
  sent_.erase(found);
  return taken;
}

void PathChain::tellLostBlends(const Sent& sent) {
  const auto& points = sent.piece->plan.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].losesBlend()) continue;
    members_[memberAt(sent.first + i)].report.blends_lost.push_back(points[i].index);
  }
}

std::vector<LoadedPiecePtr> PathChain::unsent() const {
  std::vector<LoadedPiecePtr> unsent;
  for (std::size_t i = cursor_.member; i < members_.size(); ++i) {
    const LoadedPath& loaded = *members_[i].loaded;
    const std::size_t first = i == cursor_.member ? cursor_.piece : 0;
    unsent.insert(unsent.end(), loaded.pieces.begin() + static_cast<std::ptrdiff_t>(first),
                  loaded.pieces.end());
    const bool is_sent = i == cursor_.member && open_end_sent_;
    const bool goes_on = i + 1 < members_.size() && !members_[i + 1].loaded->from_rest;
    if (loaded.open_end && !is_sent && !goes_on) unsent.push_back(loaded.open_end);
  }
  return unsent;
}

std::optional<PathChain::Feedrates> PathChain::feedrates() const {
  if (!next()) return std::nullopt;
  const auto first = members_.begin() + static_cast<std::ptrdiff_t>(memberAt(sent_points_));
  const auto [lowest, highest] = std::minmax_element(
      first, members_.end(),
      [](const Member& a, const Member& b) { return a.loaded->feedrate < b.loaded->feedrate; });
  return Feedrates{lowest->loaded->feedrate, highest->loaded->feedrate};
}

std::optional<PathRest> PathChain::rest() const {
  const auto pieces = unsent();
  if (pieces.empty()) return std::nullopt;
  PathRest rest;
  rest.start = pieces.front()->plan.at(Duration::zero()).position;
  for (std::size_t i = memberAt(sent_points_); i < members_.size(); ++i) {
    rest.parts.push_back({members_[i].loaded, {}});
  }
  auto part = rest.parts.begin();
  for (const LoadedPiecePtr& piece : pieces) {
    for (const path::PlannedPoint& point : piece->plan.points()) {
      while (part->loaded->method_id != point.goal) ++part;
      part->points.push_back(point);
    }
  }
  return rest;
}

void PathChain::reload(const std::vector<LoadedPathPtr>& loaded) {
  const std::size_t first = memberAt(sent_points_);
  assert(first + loaded.size() == members_.size());
  for (std::size_t i = 0; i < loaded.size(); ++i) {
    Member& member = members_[first + i];
    member.loaded = loaded[i];
    for (const std::string& text : loaded[i]->approximations) {
      auto& told = member.report.approximations;
      if (std::find(told.begin(), told.end(), text) == told.end()) told.push_back(text);
    }
    const std::size_t sent = std::clamp(sent_points_, member.first, member.behind()) - member.first;
    for (std::size_t point = sent; point < member.count(); ++point) {
      member.report.points[point].start = loaded[i]->report[point].start;
      member.report.points[point].duration = loaded[i]->report[point].duration;
    }
  }
  cursor_ = {first, 0};
  open_end_sent_ = false;
  ++next_key_;
  advance();
}

double PathChain::highestFeedrate() const {
  double highest = std::numeric_limits<double>::infinity();
  for (const LoadedPiecePtr& piece : unsent()) {
    if (piece->fastest <= 0) continue;
    highest = std::min(highest, piece->plan.points().front().feedrate / piece->fastest);
  }
  return highest;
}

PathPlace PathChain::placeOf(const Member& member, const Place& place) const {
  const auto inside = [&](std::size_t begin, std::size_t behind) {
    const auto first = std::clamp(begin, member.first, member.behind());
    return static_cast<int>(std::clamp(behind, first, member.behind()) - first);
  };
  const Member* const at_gate = firstAtGate();
  const std::size_t most = place.behind_active + bufferOf(member);
  const std::size_t behind_buffer = at_gate != nullptr ? std::min(most, at_gate->first) : most;
  PathPlace told;
  told.method_id = member.loaded->method_id;
  told.done_path_points = inside(0, place.done);
  told.active = inside(place.done, place.behind_active) > 0;
  told.waits_for_tracking = &member == at_gate && member.first < most;
  told.queued_path_points = inside(place.behind_active, behind_buffer);
  told.pending_path_points = inside(std::max(place.behind_active, behind_buffer), member.behind());
  told.loaded = told.pending_path_points == 0;
  if (told.active) {
    const std::size_t active = std::max(place.done, member.first) - member.first;
    told.active_path_point = member.loaded->start_index + static_cast<int>(active);
    told.active_move_id = member.loaded->move_ids[active];
  }
  return told;
}

}  // namespace cobot_command::blocks
