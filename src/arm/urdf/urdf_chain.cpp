#include "urdf_chain.h"

#include <cmath>
#include <optional>

#include "urdf_document.h"
#include <fmt/format.h>

#include "cobot_command/common/given.h"

namespace cobot_command::arm {
namespace {

/// More than twice as fast as the fastest joint of the family, and slower than anything that is meant
/// [rad/s].
constexpr double kLeastVelocity = 0.01;
constexpr double kMostVelocity = 20;
/// More turns than any joint makes [rad].
constexpr double kMostAngle = 100;
/// No link has as much [kg], or its mass as far from its frame [m].
constexpr double kMostMass = 1000;
constexpr double kMostDistance = 10;

/// What is wrong with a moving joint that should have this name, if anything.
std::optional<std::string> problemOf(const urdf::Joint& joint, const std::string& expected_name) {
  const std::string name = quoted(joint.name);
  if (joint.name != expected_name) {
    return fmt::format("the joint {} is where {} is needed. The six joints of the arm are, from the base: {}",
                       name, quoted(expected_name), fmt::join(kJointNames, ", "));
  }
  if (joint.type != urdf::Joint::REVOLUTE || !joint.limits) {
    return fmt::format(
        "the joint {} is not of type \"revolute\" with a <limit>. Set this type and add a <limit>", name);
  }
  const auto& limit = *joint.limits;
  if (!(limit.lower >= -kMostAngle && limit.upper <= kMostAngle && limit.lower < limit.upper)) {
    return fmt::format(
        "the limits of the joint {} are {} to {} rad, but the lower must be below the upper, "
        "both between -{} and {}. Correct its <limit>",
        name, limit.lower, limit.upper, kMostAngle, kMostAngle);
  }
  if (!(limit.velocity >= kLeastVelocity && limit.velocity <= kMostVelocity)) {
    return fmt::format(
        "the velocity limit of the joint {} is {} rad/s, but must be {} to {}. Correct its <limit>", name,
        limit.velocity, kLeastVelocity, kMostVelocity);
  }
  return std::nullopt;
}

/// What is wrong with the mass of a link, if anything.
std::optional<std::string> problemOf(const urdf::Link& link) {
  if (!link.inertial) return std::nullopt;
  const urdf::Inertial& body = *link.inertial;
  const urdf::Vector3& centre = body.origin.position;
  const bool is_near = std::hypot(centre.x, centre.y, centre.z) <= kMostDistance;
  if (body.mass >= 0 && body.mass <= kMostMass && is_near) return std::nullopt;
  return fmt::format(
      "the link {} has {} kg at {}, {}, {} m, but must have 0 to {} kg, at most {} m from its origin. "
      "Correct its "
      "<inertial>",
      quoted(link.name), body.mass, centre.x, centre.y, centre.z, kMostMass, kMostDistance);
}

/// Of a link, in its own frame; none for a link without.
KDL::RigidBodyInertia inertiaOf(const urdf::Link& link) {
  if (!link.inertial) return KDL::RigidBodyInertia::Zero();
  const urdf::Inertial& body = *link.inertial;
  const urdf::Vector3& centre = body.origin.position;
  const urdf::Rotation& turn = body.origin.rotation;
  const KDL::RigidBodyInertia around_centre(
      body.mass, KDL::Vector::Zero(),
      KDL::RotationalInertia(body.ixx, body.iyy, body.izz, body.ixy, body.ixz, body.iyz));
  return KDL::Frame(KDL::Rotation::Quaternion(turn.x, turn.y, turn.z, turn.w),
                    KDL::Vector(centre.x, centre.y, centre.z)) *
         around_centre;
}

KDL::Segment segmentOf(const urdf::Joint& joint, const urdf::Link& link) {
  const urdf::Pose& origin = joint.parent_to_joint_origin_transform;
  const KDL::Frame frame(
      KDL::Rotation::Quaternion(origin.rotation.x, origin.rotation.y, origin.rotation.z, origin.rotation.w),
      KDL::Vector(origin.position.x, origin.position.y, origin.position.z));
  if (joint.type == urdf::Joint::FIXED) {
    return KDL::Segment(joint.child_link_name, KDL::Joint(joint.name, KDL::Joint::None), frame,
                        inertiaOf(link));
  }
  const KDL::Vector axis = frame.M * KDL::Vector(joint.axis.x, joint.axis.y, joint.axis.z);
  return KDL::Segment(joint.child_link_name, KDL::Joint(joint.name, frame.p, axis, KDL::Joint::RotAxis),
                      frame, inertiaOf(link));
}

ModelError in(const std::string& robot, const std::string& problem) {
  return {fmt::format("In the URDF {} {}.", quoted(robot), problem)};
}

}  // namespace

Result<UrdfChain, ModelError> readUrdfChain(const std::string& urdf) {
  const auto document = readUrdfDocument(urdf);
  if (!document) return refuse(document.error());

  UrdfChain result;
  result.robot_name = document->model->getName();
  std::size_t count = 0;
  for (const auto& joint : document->path) {
    if (joint->type != urdf::Joint::FIXED) {
      if (count == kJointCount) {
        return refuse(in(result.robot_name,
                         fmt::format("the moving joint {} is behind the six of the arm. Make it fixed or "
                                     "take it out",
                                     quoted(joint->name))));
      }
      if (const auto problem = problemOf(*joint, document->prefix + kJointNames[count])) {
        return refuse(in(result.robot_name, *problem));
      }
      result.joint_names[count] = joint->name;
      result.limits[count] = {joint->limits->lower, joint->limits->upper, joint->limits->velocity};
      ++count;
    }
    const auto link = document->model->getLink(joint->child_link_name);
    if (const auto problem = problemOf(*link)) return refuse(in(result.robot_name, *problem));
    result.chain.addSegment(segmentOf(*joint, *link));
  }
  if (count != kJointCount) {
    return refuse(
        ModelError{fmt::format("The URDF {} has {} moving joints from the base to the flange, but the arm "
                               "has six: {}. Add the missing ones.",
                               quoted(result.robot_name), count, fmt::join(kJointNames, ", "))});
  }
  return result;
}

}  // namespace cobot_command::arm
