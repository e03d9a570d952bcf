// What a controller's status stream says of the robot, in SI; the same for a real and a simulated one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/controller_identity.h"
#include "cobot_command/link/digital_levels.h"

namespace cobot_command::link {

/// An absent value: the controller's data table does not stream that item.
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
  std::optional<bool> linked;  ///< the stream's server reaches the controller
  std::optional<bool> error;
  std::optional<int> error_code;
  std::optional<std::string> error_text;  ///< Error_Content, or in few words what the code means, if known
  std::optional<bool> emergency_stop;
  std::optional<bool> safeguard;
  std::optional<bool> project_running;
  std::optional<bool> project_paused;
  std::optional<int> project_speed_percent;
  std::vector<std::string>
      unreadable;  ///< items that the stream has, with a value that cannot be one of theirs
  /// Between which angles the safety functions let the joints be [rad].
  std::optional<arm::JointVector> safety_lower;
  std::optional<arm::JointVector> safety_upper;
  DigitalLevels inputs;
  DigitalLevels outputs;
  std::optional<int> operating_mode;  ///< MA_Mode: 0 none, 1 automatic, 2 manual
  ControllerIdentity identity;        ///< of the stream, or asked for
};

}  // namespace cobot_command::link
