#include "paths/path_stand.h"

#include <algorithm>
#include <limits>

#include "cobot_command/path/driven_path.h"

namespace cobot_command::blocks {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(5);
/// As near as any [rad]: what a joint that rests may seem to move.
constexpr double kAsNear = 2e-3;

struct Candidate {
  PathStand stand;
  double gap = 0;  ///< of the joint that is farthest from there [rad]
};

/// In the order of the path.
std::vector<Candidate> candidates(const std::vector<SentPiece>& pieces, const PathStand& certain,
                                  const arm::JointVector& joints) {
  std::vector<Candidate> found;
  Duration passed{};
  for (const SentPiece& sent : pieces) {
    if (sent.behind() <= certain.point) continue;
    const path::PathPlan& plan = sent.piece->plan;
    const bool begins_inside = sent.first <= certain.point;
    Duration time =
        begins_inside ? plan.points()[certain.point - sent.first].start + certain.time : Duration::zero();
    for (; time <= plan.duration() && passed <= path::kLongestStop; time += kStep, passed += kStep) {
      const double gap = (plan.at(time).position - joints).cwiseAbs().maxCoeff();
      found.push_back({standAt(*sent.piece, sent.first, time), gap});
    }
  }
  return found;
}

}  // namespace

PathStand standAt(const LoadedPiece& piece, std::size_t first, Duration time) {
  const auto place = piece.plan.placeAt(time);
  const std::size_t point = place.point + (place.blends ? 1 : 0);
  return {first + point, time - piece.plan.points()[point].start};
}

PathStand standOn(const std::vector<SentPiece>& pieces, const PathStand& certain,
                  const arm::JointVector& joints) {
  const auto found = candidates(pieces, certain, joints);
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& one : found) least = std::min(least, one.gap);
  const auto first = std::find_if(found.begin(), found.end(),
                                  [least](const Candidate& one) { return one.gap <= least + kAsNear; });
  return first == found.end() ? certain : first->stand;
}

}  // namespace cobot_command::blocks
