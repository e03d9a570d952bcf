#include "displays/link_poses.h"

#include <utility>
#include <vector>

namespace cobot_command::rviz_plugin {
namespace {

Eigen::Isometry3d toIsometry(const urdf::Pose& pose) {
  Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
  isometry.translation() << pose.position.x, pose.position.y, pose.position.z;
  isometry.linear() = Eigen::Quaterniond(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z)
                          .toRotationMatrix();
  return isometry;
}

/// What the joint adds to its origin.
Eigen::Isometry3d motionOf(const urdf::Joint& joint, double value) {
  const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  if (joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS) {
    motion.rotate(Eigen::AngleAxisd(value, axis.normalized()));
  } else if (joint.type == urdf::Joint::PRISMATIC) {
    motion.translate(value * axis.normalized());
  }
  return motion;
}

}  // namespace

std::map<std::string, Eigen::Isometry3d> linkPoses(const urdf::ModelInterface& model,
                                                   const std::map<std::string, double>& joints) {
  std::map<std::string, Eigen::Isometry3d> poses;
  std::vector<std::pair<urdf::LinkConstSharedPtr, Eigen::Isometry3d>> open;
  open.emplace_back(model.getRoot(), Eigen::Isometry3d::Identity());
  while (!open.empty()) {
    const auto [link, pose] = open.back();
    open.pop_back();
    poses[link->name] = pose;
    for (const urdf::JointSharedPtr& joint : link->child_joints) {
      const auto value = joints.find(joint->name);
      const Eigen::Isometry3d moved = motionOf(*joint, value == joints.end() ? 0 : value->second);
      open.emplace_back(model.getLink(joint->child_link_name),
                        pose * toIsometry(joint->parent_to_joint_origin_transform) * moved);
    }
  }
  return poses;
}

}  // namespace cobot_command::rviz_plugin
