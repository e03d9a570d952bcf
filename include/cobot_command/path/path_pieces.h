// Divides a path into pieces from rest to rest, and converts each to the PVT that is sent for it.
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
  PathPlan plan;   ///< starts at time 0
  PvtBlock block;  ///< of all points of the plan
};

struct PieceLimits {
  Duration segment = motion::kLeastSegment;  ///< shortest segment; whole milliseconds
  std::size_t most_points = 5000;            ///< in one PVT
};

/// The pieces of the whole plan, in order. Each PVT is planned from the end of the previous one, exactly as
/// in the forecast and in the simulated arm, so a PVT that is valid here is accepted there. Refused with the
/// first point whose motion would not be accepted (16#204, 1047, 16#206), or at which a PVT becomes too long
/// (16#277).
///
/// For a path accepted by PathPlanner and the shortest segment, the only possible refusal is 16#277.
[[nodiscard]] Result<std::vector<PathPiece>, PathRefusal> piecesOf(const PathPlan& plan,
                                                                   const PathScene& scene,
                                                                   const PieceLimits& limits = {});

}  // namespace cobot_command::path
