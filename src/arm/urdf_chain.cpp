#include "urdf_chain.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

namespace cobot_command::arm {
namespace {

constexpr std::array<const char*, kJointCount> kJointNames = {
    "shoulder_1_joint", "shoulder_2_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"};
constexpr const char* kBase = "base";
constexpr const char* kFlange = "flange_link";

/// While it lives, what urdfdom would print is collected instead. The output handler of console_bridge is one
/// for the process, hence the lock.
class UrdfdomMessages : private console_bridge::OutputHandler {
 public:
  UrdfdomMessages() : lock_(mutex()), previous_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~UrdfdomMessages() override { console_bridge::useOutputHandler(previous_); }
  UrdfdomMessages(const UrdfdomMessages&) = delete;
  UrdfdomMessages& operator=(const UrdfdomMessages&) = delete;

  /// All errors, the particular before the general; empty when there was none.
  [[nodiscard]] const std::string& errors() const { return errors_; }

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    errors_ += (errors_.empty() ? "" : "; ") + text;
  }
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }

  std::lock_guard<std::mutex> lock_;
  console_bridge::OutputHandler* previous_;
  std::string errors_;
};

Result<urdf::ModelInterfaceSharedPtr, ModelError> parse(const std::string& text) {
  const UrdfdomMessages messages;
  std::string problem;
  try {
    if (auto model = urdf::parseURDF(text)) return model;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (problem.empty()) problem = messages.errors();
  if (problem.empty()) problem = "it is not XML with one <robot>";
  return refuse(
      ModelError{fmt::format("This is not a URDF: {}. Give the text of a complete URDF.", problem)});
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// What stands before "shoulder_1_joint".
Result<std::string, ModelError> prefixOf(const urdf::ModelInterface& model) {
  std::vector<std::string> prefixes;
  for (const auto& [name, joint] : model.joints_) {
    if (endsWith(name, kJointNames[0])) {
      prefixes.push_back(name.substr(0, name.size() - std::string(kJointNames[0]).size()));
    }
  }
  if (prefixes.size() == 1) return prefixes.front();
  return refuse(ModelError{fmt::format(
      "The URDF \"{}\" has {} joints whose name ends in \"{}\", but a model is one arm with exactly one. "
      "Give the URDF of one arm, with the joint names of the TM driver.",
      model.getName(), prefixes.size(), kJointNames[0])});
}

/// The links of urdfdom own their children: in a ring they own each other, and the memory would be lost.
void releaseRings(const urdf::ModelInterface& model) {
  for (const auto& [name, link] : model.links_) link->child_links.clear();
}

/// The joints from the base to the flange, in this order.
Result<std::vector<urdf::JointConstSharedPtr>, ModelError> pathOf(const urdf::ModelInterface& model,
                                                                  const std::string& prefix) {
  const std::string base = prefix + kBase;
  const std::string flange = prefix + kFlange;
  std::vector<urdf::JointConstSharedPtr> path;
  auto link = model.getLink(flange);
  // A URDF may hide a ring of links beside its tree, hence the bound.
  while (link && link->name != base && link->parent_joint && path.size() <= model.joints_.size()) {
    path.push_back(link->parent_joint);
    link = model.getLink(link->parent_joint->parent_link_name);
  }
  if (!link || link->name != base) {
    releaseRings(model);
    return refuse(ModelError{
        fmt::format("The URDF \"{}\" has no chain of joints from the link \"{}\" to the link \"{}\". "
                    "Name the first and the last link of the arm so.",
                    model.getName(), base, flange)});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/// What is wrong with the k-th moving joint of the path, if anything.
std::optional<std::string> problemOf(const urdf::Joint& joint, const std::string& expected_name) {
  if (joint.name != expected_name) {
    return fmt::format(
        "the joint \"{}\" stands where \"{}\" is needed. The six joints of the arm are, from "
        "the base: {}",
        joint.name, expected_name, fmt::join(kJointNames, ", "));
  }
  if (joint.type != urdf::Joint::REVOLUTE || !joint.limits) {
    return fmt::format("the joint \"{}\" is not of type \"revolute\" with a <limit>. Make it so", joint.name);
  }
  const auto& limit = *joint.limits;
  if (!(std::isfinite(limit.lower) && std::isfinite(limit.upper) && limit.lower < limit.upper)) {
    return fmt::format(
        "the limits of the joint \"{}\" are {} to {} rad, but the lower must be below the upper, "
        "both finite. Correct its <limit>",
        joint.name, limit.lower, limit.upper);
  }
  if (!(std::isfinite(limit.velocity) && limit.velocity > 0)) {
    return fmt::format(
        "the velocity limit of the joint \"{}\" is {} rad/s, but must be positive. Correct its "
        "<limit>",
        joint.name, limit.velocity);
  }
  return std::nullopt;
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

}  // namespace

Result<UrdfChain, ModelError> readUrdfChain(const std::string& urdf) {
  const auto model = parse(urdf);
  if (!model) return refuse(model.error());
  const auto prefix = prefixOf(**model);
  if (!prefix) return refuse(prefix.error());
  const auto path = pathOf(**model, *prefix);
  if (!path) return refuse(path.error());

  UrdfChain result;
  result.robot_name = (*model)->getName();
  std::size_t count = 0;
  for (const auto& joint : *path) {
    if (joint->type != urdf::Joint::FIXED) {
      const std::string expected = count < kJointCount ? *prefix + kJointNames[count] : "no further joint";
      if (const auto problem = problemOf(*joint, expected)) {
        return refuse(ModelError{fmt::format("In the URDF \"{}\" {}.", result.robot_name, *problem)});
      }
      result.joint_names[count] = joint->name;
      result.limits[count] = {joint->limits->lower, joint->limits->upper, joint->limits->velocity};
      ++count;
    }
    result.chain.addSegment(segmentOf(*joint, *(*model)->getLink(joint->child_link_name)));
  }
  if (count != kJointCount) {
    return refuse(ModelError{
        fmt::format("The URDF \"{}\" has {} moving joints from the base to the flange, but the arm "
                    "has six: {}. Add the missing ones.",
                    result.robot_name, count, fmt::join(kJointNames, ", "))});
  }
  return result;
}

}  // namespace cobot_command::arm
