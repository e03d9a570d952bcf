// Whether zones are enough, found out anew without voxels (cell.md, M17): wherever no zone keeps two robots
// apart, their bodies are at least the margin apart.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/cell/claims/claims.h"
#include "cobot_command/cell/zones/holds.h"

namespace cobot_command::cell {

struct Soundness {
  std::vector<std::string>
      faults;             ///< each a sentence with robots, paths, steps and what is left between them
  double least = 0.0;     ///< what is left between the worst pair [m]
  std::string worst;      ///< that pair: "RA HOME>T1 step 2, RB at HOME"
  std::size_t pairs = 0;  ///< of pieces that were looked at
};

/// Of all pairs of pieces of different robots that no zone is held in both, and of all pieces with the
/// obstacles: the distance of all bodies at the centres, less what they can move.
[[nodiscard]] Soundness checkSoundness(const Cell& cell, const std::vector<RobotClaim>& claims,
                                       const HeldCell& held);

}  // namespace cobot_command::cell
