// What a robot has at its flange, always and by its program.
#pragma once

#include <vector>

#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/plan/planned_cell.h"
#include "cobot_command/cell/program/cell.h"

namespace cobot_command::cell {

/// Precondition, here and below: claims were made of the cell, so that all shapes are right.
[[nodiscard]] std::vector<FlangeCapsules> toolOf(const Cell& cell, const Robot& robot);

/// All parts that it carries somewhere, by name.
[[nodiscard]] std::vector<FlangeCapsules> partsOf(const Cell& cell, const PlannedRobot& robot);

}  // namespace cobot_command::cell
