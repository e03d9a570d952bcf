// What a robot carries at a place of its program.
#pragma once

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/model/cell_model.h"

namespace cobot_command::cell {

/// All parts that it may have at some moment while it is at this place: in any frame that it can be in, and
/// what it takes or has not set down yet where that ends. Precondition: a robot, and no mechanism, of the
/// artifact.
[[nodiscard]] Carried carriedAt(const Artifact& artifact, RobotIndex robot, const CellPlace& place);

}  // namespace cobot_command::cell
