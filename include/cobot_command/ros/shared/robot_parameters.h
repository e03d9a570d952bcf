// What both nodes are told of the robot: its model and the prefix of its names, held against the
// robot_description that RViz and tf use.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/setting.h"

namespace cobot_command::ros_adapter {

[[nodiscard]] Setting robotModelRow(std::string& robot_model);
[[nodiscard]] Setting prefixRow(std::string& prefix);

struct RobotParameters {
  std::string robot_model;  ///< empty: of the robot_description
  std::string prefix;       ///< in front of joint and frame names
};

/// The model that is named, else that of the description; nothing when there is neither. A description of
/// another model of the family is a fault: what RViz shows would not be what is planned. One of the same
/// model with other lengths or names is worth a warning; one of something else, a whole cell for instance, is
/// nobody's fault.
[[nodiscard]] Result<std::optional<arm::ArmModel>, SettingFault> armOf(
    const RobotParameters& robot, const std::optional<Given>& robot_description,
    std::vector<std::string>& warnings);

}  // namespace cobot_command::ros_adapter
