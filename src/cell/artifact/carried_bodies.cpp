#include "artifact/carried_bodies.h"

#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/cell/claims/cell_bodies.h"

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
  return partTreeOf(cell)->bodiesOf(carried);
}

}  // namespace cobot_command::cell
