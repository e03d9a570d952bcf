#include "robot/tool_twist.h"

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator {

Twist toolTwist(const arm::ArmModel& arm, const RobotState& robot) {
  Twist twist = arm::jacobianAt(arm, robot.joints) * robot.velocities;
  const Eigen::Vector3d lever = robot.flange.linear() * robot.tcp.translation();
  const Eigen::Vector3d angular = twist.tail<3>();
  twist.head<3>() += angular.cross(lever);
  return twist;
}

float linearSpeed(const Twist& twist) {
  return static_cast<float>(mToMm(twist.head<3>().norm()));
}

}  // namespace cobot_command::simulator
