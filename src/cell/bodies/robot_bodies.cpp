#include "cobot_command/cell/bodies/robot_bodies.h"

#include <variant>

#include "cobot_command/arm/collision_shapes.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::cell {
namespace {

Shape shapeOf(const arm::CollisionShape& collision) {
  Shape shape;
  shape.at = collision.at;
  std::visit(Overloaded{[&](const arm::CollisionCylinder& cylinder) {
                          shape.kind = CylinderShape{cylinder.radius, cylinder.length};
                        },
                        [&](const arm::CollisionBox& box) { shape.kind = BoxShape{box.size}; },
                        [&](const arm::CollisionSphere& sphere) { shape.kind = SphereShape{sphere.radius}; }},
             collision.kind);
  return shape;
}

Result<std::vector<Body>, BodyRefusal> bodiesOfLinks(const std::string& urdf, double body_cell) {
  const auto collisions = arm::collisionShapes(urdf);
  if (!collisions) return refuse(BodyRefusal{collisions.error().message});
  std::vector<Body> bodies;
  for (const arm::CollisionShape& collision : *collisions) {
    const auto capsules = capsulesOf(shapeOf(collision), body_cell);
    if (!capsules) return refuse(capsules.error());
    for (const Capsule& capsule : *capsules) bodies.push_back({collision.link, capsule, collision.link_name});
  }
  return bodies;
}

}  // namespace

RobotBodies::RobotBodies(const arm::ArmModel& arm, const arm::Pose& base) : chain_(arm), base_(base) {}

bool isFixed(const Body& body) {
  constexpr double kOnAxis = 1e-6;  // of joint 1, which is the z axis of link 1 [m]
  const auto is_on_axis = [](const Eigen::Vector3d& end) { return end.head<2>().norm() < kOnAxis; };
  return body.link == 0 || (body.link == 1 && is_on_axis(body.capsule.from) && is_on_axis(body.capsule.to));
}

Result<RobotBodies, BodyRefusal> RobotBodies::fromUrdf(const std::string& urdf, const arm::Pose& base,
                                                       const std::vector<Shape>& tool, double body_cell) {
  const auto arm = arm::ArmModel::fromUrdf(urdf);
  if (!arm) return refuse(BodyRefusal{arm.error().message});
  auto bodies = bodiesOfLinks(urdf, body_cell);
  if (!bodies) return refuse(bodies.error());
  const auto tool_capsules = capsulesOf(tool, body_cell);
  if (!tool_capsules) return refuse(tool_capsules.error());
  RobotBodies robot(*arm, base);
  robot.bodies_ = std::move(*bodies);
  robot.addAtFlange({"tool", *tool_capsules});
  return robot;
}

RobotBodies RobotBodies::carrying(const std::vector<FlangeCapsules>& carried) const {
  RobotBodies robot(*this);
  for (const FlangeCapsules& things : carried) robot.addAtFlange(things);
  return robot;
}

void RobotBodies::addAtFlange(const FlangeCapsules& things) {
  for (const Capsule& capsule : things.capsules) {
    bodies_.push_back({arm::kJointCount, placed(chain_.flange(), capsule), things.name});
  }
}

PlacedRobot RobotBodies::at(const arm::JointVector& joints) const {
  PlacedRobot placed;
  place(joints, placed);
  return placed;
}

void RobotBodies::place(const arm::JointVector& joints, PlacedRobot& placed) const {
  const arm::LinkFrames frames = chain_.framesAt(joints, base_);
  placed.axes = chain_.axesOf(frames);
  placed.capsules.clear();
  for (const Body& body : bodies_) placed.capsules.push_back(cell::placed(frames[body.link], body.capsule));
}

}  // namespace cobot_command::cell
