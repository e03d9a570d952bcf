// The robot's state as reported by the controller's status stream, in SI units; the same for a real and a
// simulated controller.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/controller_identity.h"
#include "cobot_command/link/digital_levels.h"

namespace cobot_command::link {

/// nullopt: the controller's data table does not stream that item.
struct RobotStatus {
  Instant received{};
  std::optional<arm::JointVector> joints;            ///< [rad]
  std::optional<arm::JointVector> joint_velocities;  ///< [rad/s]
  std::optional<arm::JointVector> joint_torques;     ///< [Nm]
  std::optional<arm::Pose> flange;                   ///< in the robot base [m]
  std::optional<arm::Pose> tool;                     ///< the active TCP in the robot base [m]
  std::optional<arm::Pose> base;                     ///< the active base in the robot base [m]
  std::optional<arm::Pose> tcp;                      ///< the active TCP in the flange [m]
  std::optional<double> tcp_mass;                    ///< of the tool [kg]
  std::optional<double> tool_speed;                  ///< of the active TCP [m/s]
  std::optional<std::string> base_name;
  std::optional<std::string> tcp_name;
  std::optional<bool> linked;  ///< the server of the stream reaches the controller
  std::optional<bool> error;
  std::optional<int> error_code;
  /// Error_Content, or a short text for the code, if known.
  std::optional<std::string> error_text;
  std::optional<bool> emergency_stop;
  std::optional<bool> safeguard;
  std::optional<bool> project_running;
  std::optional<bool> project_paused;
  std::optional<int> project_speed_percent;
  /// Items of the stream with a value that is impossible for them.
  std::vector<std::string> unreadable;
  /// Joint limits of the safety functions [rad].
  std::optional<arm::JointVector> safety_lower;
  std::optional<arm::JointVector> safety_upper;
  DigitalLevels inputs;
  DigitalLevels outputs;
  std::optional<int> operating_mode;  ///< MA_Mode: 0 none, 1 automatic, 2 manual
  ControllerIdentity identity;        ///< from the stream, or requested
};

}  // namespace cobot_command::link
