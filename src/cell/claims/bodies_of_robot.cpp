#include "claims/bodies_of_robot.h"

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::cell {

Result<BodiesOfRobot, std::string> BodiesOfRobot::of(const Cell& cell, const Robot& robot) {
  const double body_cell = cell.parameters.body_cell;
  auto bare = RobotBodies::fromUrdf(arm::ArmModel::urdfOf(robot.model), robot.base, robot.tool, body_cell);
  if (!bare) return refuse(bare.error().message);
  std::vector<CarriedPart> parts;
  for (const Part& part : cell.parts) {
    parts.push_back({part.name, part.shapes, part.on.empty() ? kOnFlange : part.on, part.at});
  }
  auto tree = PartTree::of(parts, body_cell);
  if (!tree) return refuse(tree.error().message);
  return BodiesOfRobot(std::move(*bare), std::move(*tree));
}

std::shared_ptr<const RobotBodies> BodiesOfRobot::carrying(const std::set<std::string>& parts) {
  auto& bodies = known_[parts];
  if (!bodies) bodies = std::make_shared<const RobotBodies>(bare_.carrying(parts_.bodiesOf(parts)));
  return bodies;
}

}  // namespace cobot_command::cell
