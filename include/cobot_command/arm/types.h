// Types that arm/ and motion/ share: joint vectors and poses, in SI (rad, m).
#pragma once

#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace cobot_command::arm {

inline constexpr std::size_t kJointCount = 6;

/// J1..J6 in rad (velocities in rad/s).
using JointVector = Eigen::Matrix<double, 6, 1>;

/// A rigid transform in m: the pose of one frame relative to another. Each use names both frames.
using Pose = Eigen::Isometry3d;

/// Rows 0..2 linear (m/rad), rows 3..5 angular, both in the robot base.
using Jacobian = Eigen::Matrix<double, 6, 6>;

}  // namespace cobot_command::arm
