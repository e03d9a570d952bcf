// Whether a robot with measured joints can be at a place of its program.
#pragma once

#include <cstddef>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

/// At a station a robot stands where no joint is farther from it [rad].
inline constexpr double kStandsWithin = degToRad(0.5);

/// Pieces of a path, from `first` to before `end`.
struct PieceSpan {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// Where a robot can be when so many zone steps of the path's program are done: behind the last release, and
/// in no frame that needs a booking which is still to come.
[[nodiscard]] PieceSpan piecesBehind(const ArtifactPath& path, const PathProgram& program,
                                     std::size_t behind);

/// Of the position of a mechanism that was told, as nobody tracks it: [m], or [rad] of one that turns.
inline constexpr double kMechanismWithin = 0.005;

/// Whether these joints [rad] are those of a place of that robot, each within `tracking` of what is planned.
/// Of a mechanism the first one is its position [m or rad].
[[nodiscard]] bool placeFits(const Artifact& artifact, RobotIndex robot, const CellPlace& place,
                             const arm::JointVector& joints);

}  // namespace cobot_command::cell
