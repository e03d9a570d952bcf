// The bodies of the parts and mechanisms in a cell file. Proofs, artifacts and the monitor use the same
// bodies.
#pragma once

#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/program/cell.h"

namespace cobot_command::cell {

/// All parts of the cell, regardless of the carrying robot. Refused if a shape is invalid, or if the parts
/// are not a tree.
[[nodiscard]] Result<PartTree, BodyRefusal> partTreeOf(const Cell& cell);

/// Refused if a shape is invalid.
[[nodiscard]] Result<MechanismBodies, BodyRefusal> mechanismBodiesOf(const Parameters& parameters,
                                                                     const Mechanism& mechanism);

}  // namespace cobot_command::cell
