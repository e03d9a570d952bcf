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

bool PathMember::isNews(const PathPlace& place, Instant now) {
  const bool is_other = !told_at || asTuple(place) != asTuple(told);
  const bool is_due = place.active && told_at && now - *told_at >= kTellEvery;
  if (!is_other && !is_due) return false;
  told = place;
  told_at = now;
  return true;
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

std::vector<SentPiece> SentPieces::forgetTakenBack() {
  std::vector<SentPiece> taken = std::exchange(taken_back_, {});
  std::sort(taken.begin(), taken.end(),
            [](const SentPiece& a, const SentPiece& b) { return a.first < b.first; });
  return taken;
}

}  // namespace cobot_command::blocks
