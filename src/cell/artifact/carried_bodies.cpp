#include "artifact/carried_bodies.h"

#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/bodies/shape_capsules.h"

namespace cobot_command::cell {

std::vector<FlangeCapsules> toolOf(const Cell& cell, const Robot& robot) {
  if (robot.tool.empty()) return {};
  return {{"tool", *capsulesOf(robot.tool, cell.parameters.body_cell)}};
}

std::vector<FlangeCapsules> partsOf(const Cell& cell, const PlannedRobot& robot) {
  Carried carried;
  for (const PlannedStation& station : robot.stations) {
    carried.insert(station.carried.begin(), station.carried.end());
  }
  for (const PlannedPath& path : robot.paths) {
    for (const PlannedFrame& frame : path.frames) carried.insert(frame.carried.begin(), frame.carried.end());
    carried.insert(path.carried_at_end.begin(), path.carried_at_end.end());
  }
  std::vector<CarriedPart> parts;
  for (const Part& part : cell.parts) {
    parts.push_back({part.name, part.shapes, part.on.empty() ? kOnFlange : part.on, part.at});
  }
  return PartTree::of(parts, cell.parameters.body_cell)->bodiesOf(carried);
}

MechanismBodies bodiesOf(const Parameters& parameters, const Mechanism& mechanism) {
  const MotionAxis axis{mechanism.axis == Mechanism::Axis::Revolute, mechanism.at, mechanism.direction};
  return *MechanismBodies::of(axis, mechanism.shapes, parameters.body_cell);
}

}  // namespace cobot_command::cell
