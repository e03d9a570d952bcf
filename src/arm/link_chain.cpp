#include "cobot_command/arm/link_chain.h"

#include <kdl/frames.hpp>

namespace cobot_command::arm {
namespace {

Eigen::Vector3d toEigen(const KDL::Vector& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Pose toPose(const KDL::Frame& frame) {
  Pose pose = Pose::Identity();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) pose.linear()(row, column) = frame.M(row, column);
  }
  pose.translation() = toEigen(frame.p);
  return pose;
}

}  // namespace

LinkChain::LinkChain(const ArmModel& arm) {
  KDL::Frame since_joint;
  std::size_t count = 0;
  for (const KDL::Segment& segment : arm.chain().segments) {
    const KDL::Frame at_zero = segment.pose(0.0);
    since_joint = since_joint * at_zero;
    if (segment.getJoint().getType() == KDL::Joint::None) continue;
    joints_[count].origin = toPose(since_joint);
    joints_[count].direction = toEigen(at_zero.M.Inverse(segment.getJoint().JointAxis())).normalized();
    ++count;
    since_joint = KDL::Frame::Identity();
  }
  flange_ = toPose(since_joint);
}

LinkFrames LinkChain::framesAt(const JointVector& joints, const Pose& base) const {
  LinkFrames frames;
  frames[0] = base;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const Joint& joint = joints_[i];
    frames[i + 1] = frames[i] * joint.origin;
    const Eigen::AngleAxisd turn(joints[static_cast<Eigen::Index>(i)], joint.direction);
    frames[i + 1].linear() *= turn.toRotationMatrix();
  }
  return frames;
}

JointAxes LinkChain::axesOf(const LinkFrames& frames) const {
  JointAxes axes;
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const Pose& link = frames[i + 1];
    axes[i] = {link.translation(), link.linear() * joints_[i].direction};
  }
  return axes;
}

}  // namespace cobot_command::arm
