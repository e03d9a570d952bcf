// The parameters about the robot that both nodes have, the model and the prefix of names. They are checked
// against the robot_description that RViz and tf use.
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
  std::string robot_model;  ///< empty: from the robot_description
  std::string prefix;       ///< precedes joint and frame names
};

/// The named model, otherwise that of the description; nullopt: there is neither. A description of another
/// model of the family is an error, because RViz would not show what is planned. A description of the same
/// model with other lengths or names causes a warning. A description of something else, for example of a
/// whole cell, is not an error.
[[nodiscard]] Result<std::optional<arm::ArmModel>, SettingFault> armOf(
    const RobotParameters& robot, const std::optional<Given>& robot_description,
    std::vector<std::string>& warnings);

}  // namespace cobot_command::ros_adapter
