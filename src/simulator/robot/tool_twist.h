// How fast the TCP moves and turns.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/simulator/robot_state.h"

namespace cobot_command::simulator {

using Twist = Eigen::Matrix<double, 6, 1>;

/// Of the TCP in the robot base [m/s, rad/s].
[[nodiscard]] Twist toolTwist(const arm::ArmModel& arm, const RobotState& robot);
[[nodiscard]] float linearSpeed(const Twist& twist);  ///< [mm/s]

}  // namespace cobot_command::simulator
