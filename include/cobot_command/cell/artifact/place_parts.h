// The parts that a robot carries at a place of its program.
#pragma once

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/model/cell_model.h"

namespace cobot_command::cell {

/// All parts that it may carry at any time while it is at this place: in every frame that it can be in,
/// including parts that it attaches or has not detached yet at the end of that frame. Precondition: a robot
/// of the artifact, not a mechanism.
[[nodiscard]] Carried carriedAt(const Artifact& artifact, RobotIndex robot, const CellPlace& place);

}  // namespace cobot_command::cell
