#include "claims/bodies_of_robot.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/cell/claims/cell_bodies.h"

namespace cobot_command::cell {

Result<BodiesOfRobot, std::string> BodiesOfRobot::of(const Cell& cell, const Robot& robot) {
  auto bare = RobotBodies::fromUrdf(arm::ArmModel::urdfOf(robot.model), robot.base, robot.tool,
                                    cell.parameters.body_cell);
  if (!bare) return refuse(bare.error().message);
  auto tree = partTreeOf(cell);
  if (!tree) return refuse(tree.error().message);
  return BodiesOfRobot(std::move(*bare), std::move(*tree));
}

std::shared_ptr<const RobotBodies> BodiesOfRobot::carrying(const std::set<std::string>& parts) {
  auto& bodies = known_[parts];
  if (!bodies) bodies = std::make_shared<const RobotBodies>(bare_.carrying(parts_.bodiesOf(parts)));
  return bodies;
}

}  // namespace cobot_command::cell
