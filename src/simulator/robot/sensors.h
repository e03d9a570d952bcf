// What the robot says of itself: torques and currents from its weight, and the noise of its sensors.
#pragma once

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

/// The state with the noise of the settings on joints, speeds and force; the flange is where the measured
/// joints put it. The noise is a function of the seed and the time alone: who asks, and how often, changes
/// nothing.
[[nodiscard]] RobotState measured(RobotState truth, const arm::ArmModel& arm, const Settings& settings);

/// The torques [Nm] that hold arm, tool and load, `before` the time of the state (as if it had had its speed
/// since), with their noise. The tool's weight is at its mass centre, the load at the TCP.
[[nodiscard]] arm::JointVector jointTorques(const RobotState& robot, const arm::ArmModel& arm,
                                            const Settings& settings, Duration before = {});

/// Of all joints in the last 40 ms [Nm]: three samples stand for them.
struct TorqueWindow {
  arm::JointVector average, least, most;
};
[[nodiscard]] TorqueWindow torqueWindow(const RobotState& robot, const arm::ArmModel& arm,
                                        const Settings& settings);

/// [A]
[[nodiscard]] arm::JointVector jointCurrents(const RobotState& robot, const arm::ArmModel& arm,
                                             const Settings& settings);

}  // namespace cobot_command::simulator
