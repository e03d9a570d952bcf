// Checks whether a robot with measured joints can be at a place of its program.
#pragma once

#include <cstddef>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {

/// A robot is at a station if no joint is farther from it than this [rad].
inline constexpr double kStandsWithin = degToRad(0.5);

/// Pieces of a path, from `first` up to, not including, `end`.
struct PieceSpan {
  std::size_t first = 0;
  std::size_t end = 0;
};

/// The pieces in which a robot can be after `behind` zone steps of the path's program: after the last
/// release, and in no frame that needs a later booking.
[[nodiscard]] PieceSpan piecesBehind(const ArtifactPath& path, const PathProgram& program,
                                     std::size_t behind);

/// Tolerance of the reported position of a mechanism, because it is not tracked: [m], or [rad] for a revolute
/// axis.
inline constexpr double kMechanismWithin = 0.005;

/// True if these joints [rad] match a place of that robot, each within `tracking` of the plan. For a
/// mechanism the first value is its position [m or rad].
[[nodiscard]] bool placeFits(const Artifact& artifact, RobotIndex robot, const CellPlace& place,
                             const arm::JointVector& joints);

}  // namespace cobot_command::cell
