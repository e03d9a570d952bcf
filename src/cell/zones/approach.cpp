#include "zones/approach.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

class Approach {
 public:
  explicit Approach(const Piece& rest)
      : capsules_(rest.capsulesAtCentre()), box_(boxAround(capsules_)), moves_(rest.displacement) {}

  /// Whether nothing that was looked at before comes as near.
  bool isNearest(const Piece& piece) {
    const Capsules others = piece.capsulesAtCentre();
    const double moved = moves_ + piece.displacement;
    if (leastDistance(box_, boxAround(others)) - moved >= least_) return false;
    const double left = nearestOf(capsules_, others).distance - moved;
    if (left >= least_) return false;
    least_ = left;
    return true;
  }
  [[nodiscard]] double least() const { return least_; }

 private:
  Capsules capsules_;
  AlignedBox box_;
  double moves_;
  double least_ = std::numeric_limits<double>::infinity();
};

}  // namespace

std::string nearestApproach(const Piece& rest, const RobotClaim& other, const CourseNames& names,
                            const Parameters& parameters) {
  Approach approach(rest);
  std::string where;
  for (std::size_t station = 0; station < other.stations.size(); ++station) {
    if (approach.isNearest(other.stations[station])) where = " at " + names.stations[station];
  }
  for (std::size_t path = 0; path < other.paths.size(); ++path) {
    for (const Piece& piece : other.paths[path].pieces) {
      if (!approach.isNearest(piece)) continue;
      where = " on " + names.paths[path];
      if (!piece.isOfMechanism()) where += fmt::format(", step {},", names.steps[path][piece.frame] + 1);
    }
  }
  // Voxels of two claims are the same only where both have a body within claimError() of them.
  const double enough = 2.0 * claimError(parameters);
  return fmt::format("{}{} comes within {:.1f} mm of it: {:.1f} mm more distance is enough", names.name,
                     where, mToMm(approach.least()), mToMm(std::max(0.0, enough - approach.least())));
}

}  // namespace cobot_command::cell
