// Poses as messages have them (m, quaternions), as forms have them (mm, degrees about fixed axes), and as one
// calculates with them.
#pragma once

#include <array>

#include <Eigen/Geometry>
#include <geometry_msgs/Pose.h>

namespace cobot_command::rviz_plugin {

[[nodiscard]] Eigen::Isometry3d toIsometry(const geometry_msgs::Pose& pose);
[[nodiscard]] geometry_msgs::Pose toPose(const Eigen::Isometry3d& isometry);
/// x, y, z [mm], rx, ry, rz [deg]: R = Rz(rz) Ry(ry) Rx(rx), as the pendant has it (Transformation.msg).
[[nodiscard]] Eigen::Isometry3d toIsometry(const std::array<double, 6>& six);
[[nodiscard]] std::array<double, 6> toSix(const Eigen::Isometry3d& isometry);

}  // namespace cobot_command::rviz_plugin
