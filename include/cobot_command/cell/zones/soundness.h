// Checks independently of voxels that the zones are sufficient (doc/cell.md): if no zone keeps two robots
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
      faults;             ///< one sentence each, with robots, paths, steps and their remaining distance
  double least = 0.0;     ///< remaining distance of the worst pair [m]
  std::string worst;      ///< the worst pair: "RA HOME>T1 step 2, RB at HOME"
  std::size_t pairs = 0;  ///< number of checked pairs of pieces
};

/// Checks all pairs of pieces of different robots that have no held zone in common, and all pieces with the
/// obstacles: the distance of all bodies at the centres, minus their possible displacement.
[[nodiscard]] Soundness checkSoundness(const Cell& cell, const std::vector<RobotClaim>& claims,
                                       const HeldCell& held);

}  // namespace cobot_command::cell
