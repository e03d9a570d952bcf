#include "chain/path_member.h"

#include <algorithm>
#include <tuple>

namespace cobot_command::blocks {
namespace {

/// How far it is on its way is told so often, as long as nothing else changes.
constexpr Duration kTellEvery = std::chrono::milliseconds(100);

auto asTuple(const PathPlace& p) {
  return std::tie(p.waits_for_tracking, p.loaded, p.active, p.active_path_point, p.pending_path_points,
                  p.queued_path_points, p.done_path_points);
}

}  // namespace

void PathMember::pointDone(std::size_t point, Instant now) {
  if (began) report.points[point - first].done = now - *began;
}

void PathMember::forgetLostBlends(std::size_t point) {
  const int left = loaded->start_index + static_cast<int>(std::clamp(point, first, behind()) - first);
  auto& lost = report.blends_lost;
  lost.erase(std::remove_if(lost.begin(), lost.end(), [left](int index) { return index >= left; }),
             lost.end());
}

bool PathMember::isNews(const PathPlace& place, Instant now) {
  const bool is_other = !told_at || asTuple(place) != asTuple(told);
  const bool is_due = place.active && told_at && now - *told_at >= kTellEvery;
  if (!is_other && !is_due) return false;
  told = place;
  told_at = now;
  return true;
}

bool SentPiece::isMarked(std::size_t point) const {
  const auto& marked = piece->marked;
  return point + 1 == behind() || std::find(marked.begin(), marked.end(), point - first) != marked.end();
}

bool SentPieces::has(CommandKey key) const {
  return std::any_of(pieces_.begin(), pieces_.end(),
                     [key](const SentPiece& sent) { return sent.key == key; });
}

SentPiece SentPieces::take(CommandKey key) {
  const auto found =
      std::find_if(pieces_.begin(), pieces_.end(), [key](const SentPiece& sent) { return sent.key == key; });
  SentPiece taken = *found;
  pieces_.erase(found);
  return taken;
}

/// They may come in any order.
void SentPieces::takeBack(CommandKey key) {
  taken_back_.push_back(take(key));
  std::sort(taken_back_.begin(), taken_back_.end(),
            [](const SentPiece& a, const SentPiece& b) { return a.first < b.first; });
}

std::vector<SentPiece> SentPieces::forgetTakenBack() {
  return std::exchange(taken_back_, {});
}

}  // namespace cobot_command::blocks
