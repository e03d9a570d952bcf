// What a cell's file says of parts and mechanisms, as bodies: the same for what is proved, for what is
// written down, and for the monitor.
#pragma once

#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/program/cell.h"

namespace cobot_command::cell {

/// All parts of the cell, whoever carries them. Refused where a shape of one is none, or they are no tree.
[[nodiscard]] Result<PartTree, BodyRefusal> partTreeOf(const Cell& cell);

/// Refused where one of its shapes is none.
[[nodiscard]] Result<MechanismBodies, BodyRefusal> mechanismBodiesOf(const Parameters& parameters,
                                                                     const Mechanism& mechanism);

}  // namespace cobot_command::cell
