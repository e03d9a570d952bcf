// A path in pieces from rest to rest, each as the one PVT that is sent for it.
#pragma once

#include <cstddef>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/path/path_plan.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/path/path_scene.h"
#include "cobot_command/path/pvt_block.h"

namespace cobot_command::path {

struct PathPiece {
  PathPlan plan;   ///< from time 0
  PvtBlock block;  ///< of all its points
};

struct PieceLimits {
  Duration segment = motion::kLeastSegment;  ///< at least that; whole milliseconds
  std::size_t most_points = 5000;            ///< of one PVT
};

/// Of the whole plan, in its order. Each PVT is planned as those plan it who forecast it and who make it,
/// from where the one in front of it ends: what is found good here is taken by them. Refused with the first
/// point on whose way they would not (16#204, 1047, 16#206), or on which a PVT gets too long (16#277).
///
/// Of a path that PathPlanner has taken, no piece with the least segment is refused but as 16#277.
[[nodiscard]] Result<std::vector<PathPiece>, PathRefusal> piecesOf(const PathPlan& plan,
                                                                   const PathScene& scene,
                                                                   const PieceLimits& limits = {});

}  // namespace cobot_command::path
