#include "cobot_command/cell/sweep/robot_claim.h"

#include "cobot_command/cell/sweep/capsule_claim.h"
#include "cobot_command/cell/sweep/displacement.h"

namespace cobot_command::cell {

void claimRobot(VoxelSet& set, const RobotBodies& robot, const PlacedRobot& placed,
                const arm::JointVector& half_widths, double clearance, double edge) {
  for (std::size_t i = 0; i < placed.capsules.size(); ++i) {
    Capsule grown = placed.capsules[i];
    grown.radius += displacementBound(grown, robot.bodies()[i].link, placed.axes, half_widths) + clearance;
    claimCapsule(set, grown, edge);
  }
}

}  // namespace cobot_command::cell
