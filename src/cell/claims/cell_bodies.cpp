#include "cobot_command/cell/claims/cell_bodies.h"

#include <vector>

namespace cobot_command::cell {

Result<PartTree, BodyRefusal> partTreeOf(const Cell& cell) {
  std::vector<CarriedPart> parts;
  for (const Part& part : cell.parts) {
    parts.push_back({part.name, part.shapes, part.on.empty() ? kOnFlange : part.on, part.at});
  }
  return PartTree::of(parts, cell.parameters.body_cell);
}

Result<MechanismBodies, BodyRefusal> mechanismBodiesOf(const Parameters& parameters,
                                                       const Mechanism& mechanism) {
  const MotionAxis axis{mechanism.axis == Mechanism::Axis::Revolute, mechanism.at, mechanism.direction};
  return MechanismBodies::of(axis, mechanism.shapes, parameters.body_cell);
}

}  // namespace cobot_command::cell
