// What the tests of cells share.
#pragma once

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/cell/bodies/robot_bodies.h"

namespace cobot_command::cell {

/// The tool of the demos.
inline std::vector<Shape> gripper() {
  return {{CapsuleShape{{0, 0, 0}, {0, 0, 0.120}, 0.050}, arm::Pose::Identity()}};
}

/// A TM5-900, its base as in a cell file [mm, deg].
inline RobotBodies robotAt(const arm::ControllerPose& base, const std::vector<Shape>& tool = gripper()) {
  auto robot = RobotBodies::fromUrdf(arm::ArmModel::urdfOf("tm5-900"), arm::toPose(base), tool);
  if (!robot) throw std::runtime_error(robot.error().message);
  return *robot;
}

/// The same numbers in every run.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : generator_(seed) {}

  double within(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(generator_);
  }
  bool coin() { return within(0, 1) < 0.5; }
  Eigen::Vector3d point(double size) {
    return {within(-size, size), within(-size, size), within(-size, size)};
  }
  arm::JointVector joints(double size) {
    arm::JointVector joints;
    for (Eigen::Index i = 0; i < joints.size(); ++i) joints[i] = within(-size, size);
    return joints;
  }
  arm::Pose pose(double size) {
    arm::Pose pose(
        Eigen::Quaterniond(within(-1, 1), within(-1, 1), within(-1, 1), within(-1, 1)).normalized());
    pose.translation() = point(size);
    return pose;
  }

 private:
  std::mt19937_64 generator_;
};

}  // namespace cobot_command::cell
