// How near others come to where something rests, for people who have to move one of them.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/claims/claims.h"

namespace cobot_command::cell {

/// Names by path, and by frame of it.
struct CourseNames {
  std::string name;
  std::vector<std::string> stations;
  std::vector<std::string> paths;
  /// By path and frame: the step of the path. Empty: of a mechanism.
  std::vector<std::vector<std::size_t>> steps;
};

/// "RB on T1, step 1, comes as near as 35.2 mm to it: 94.0 mm more between them are enough". Of all that the
/// other one does, what comes nearest to the bodies of `rest`, less what those can move.
[[nodiscard]] std::string nearestApproach(const Piece& rest, const RobotClaim& other,
                                          const CourseNames& names, const Parameters& parameters);

}  // namespace cobot_command::cell
