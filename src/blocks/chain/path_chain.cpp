#include "chain/path_chain.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <utility>

#include "cobot_command/path/path_rest.h"

namespace cobot_command::blocks {
namespace {

std::size_t bufferOf(const PathMember& member) {
  return static_cast<std::size_t>(member.loaded->settings.buffer);
}

/// The feedrate with which these pieces keep the rated speeds of the joints.
double highestOf(const std::vector<LoadedPiecePtr>& pieces) {
  double highest = std::numeric_limits<double>::infinity();
  for (const LoadedPiecePtr& piece : pieces) {
    if (piece->fastest <= 0) continue;
    highest = std::min(highest, piece->plan.points().front().feedrate / piece->fastest);
  }
  return highest;
}

}  // namespace

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
  const bool is_open_end_sent = open_end_sent_ && cursor_.member + 1 == members_.size();
  return is_open_end_sent ? last.closed_end : last.end;
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
  for (Member& member : members_) member.told_at.reset();
}

bool PathChain::isUntouched(std::size_t member) const {
  return sent_points_ <= members_[member].first;
}

void PathChain::dropFrom(std::size_t member) {
  assert(member > 0 && isUntouched(member));
  if (rewound_) rewound_->rest.parts.resize(member - memberAt(sent_points_));
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
    const bool is_begun = member.first < most_sent_;
    if (is_begun && !member.loaded->restoring.lines.empty()) return member.loaded->restoring;
  }
  return {};
}

LoadedPiecePtr PathChain::next() const {
  if (rewound_) return nullptr;
  const LoadedPath& loaded = *members_[cursor_.member].loaded;
  if (cursor_.piece < loaded.pieces.size()) return loaded.pieces[cursor_.piece];
  return open_end_sent_ ? nullptr : loaded.open_end;
}

bool PathChain::isNextOpen() const {
  if (rewound_) return false;
  const LoadedPath& loaded = *members_[cursor_.member].loaded;
  const bool is_last = cursor_.member + 1 == members_.size();
  return is_last && !open_end_due_ && cursor_.piece == loaded.pieces.size() && loaded.open_end &&
         !open_end_sent_;
}

void PathChain::sendNext() {
  const bool is_open = cursor_.piece == members_[cursor_.member].loaded->pieces.size();
  const Sent sent{next_key_++, next(), sent_points_};
  sent_.add(sent);
  tellLostBlends(sent);
  sent_points_ = sent.behind();
  most_sent_ = std::max(most_sent_, sent_points_);
  open_end_due_ = false;
  if (is_open) {
    open_end_sent_ = true;
  } else {
    ++cursor_.piece;
  }
  advance();
}

void PathChain::tellLostBlends(const Sent& sent) {
  const auto& points = sent.piece->plan.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& told = members_[memberAt(sent.first + i)].report.blends_lost;
    const bool is_told = std::find(told.begin(), told.end(), points[i].index) != told.end();
    const bool is_lost = sent.piece->is_exact ? points[i].losesBlend() : sent.piece->loses_blend;
    if (is_lost && !is_told) told.push_back(points[i].index);
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

PathRest PathChain::restFrom(std::size_t point, const std::vector<LoadedPiecePtr>& pieces,
                             std::size_t first) const {
  PathRest rest;
  std::transform(members_.begin() + static_cast<std::ptrdiff_t>(memberAt(point)), members_.end(),
                 std::back_inserter(rest.parts), [](const Member& member) {
                   return PathRest::Part{member.loaded, {}};
                 });
  auto part = rest.parts.begin();
  for (const LoadedPiecePtr& piece : pieces) {
    for (const path::PlannedPoint& planned : piece->plan.points()) {
      if (first++ < point) continue;
      while (part->loaded->method_id != planned.goal) ++part;
      part->points.push_back(planned);
    }
  }
  return rest;
}

std::optional<PathRest> PathChain::rest() const {
  if (rewound_) return rewound_->rest;
  const auto pieces = unsent();
  if (pieces.empty()) return std::nullopt;
  PathRest rest = restFrom(sent_points_, pieces, sent_points_);
  rest.start = pieces.front()->plan.at(Duration::zero()).position;
  rest.is_begun = rest.parts.front().points.size() < rest.parts.front().loaded->move_ids.size();
  return rest;
}

void PathChain::rewind(std::size_t point, Duration time, const arm::JointVector& joints) {
  assert(sent_.empty());
  const std::vector<Sent> taken_back = sent_.forgetTakenBack();
  const std::size_t first = taken_back.empty() ? sent_points_ : taken_back.front().first;
  std::vector<LoadedPiecePtr> pieces;
  pieces.reserve(taken_back.size());
  for (const Sent& sent : taken_back) pieces.push_back(sent.piece);
  const auto behind = unsent();
  pieces.insert(pieces.end(), behind.begin(), behind.end());
  PathRest rest = restFrom(point, pieces, first);
  rest.start = joints;
  rest.is_begun = true;
  path::PlannedPoint& active = rest.parts.front().points.front();
  rest.left = std::max(active.motion->duration() - time, Duration::zero());
  active = path::restOf(active, time, rest.parts.front().loaded->end->scene().arm);
  for (Member& member : members_) member.forgetLostBlends(point);
  rewound_ = Rewound{std::move(rest), highestOf(pieces)};
  cursor_ = {memberAt(point), 0};
  open_end_sent_ = false;
  sent_points_ = point;
  ++next_key_;
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
  rewound_.reset();
  ++next_key_;
  advance();
}

double PathChain::highestFeedrate(bool with_sent) const {
  if (rewound_) return rewound_->highest;
  std::vector<LoadedPiecePtr> pieces = unsent();
  if (with_sent) {
    for (const SentPiece& sent : sent_.all()) pieces.push_back(sent.piece);
    for (const SentPiece& sent : sent_.takenBack()) pieces.push_back(sent.piece);
  }
  return highestOf(pieces);
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
