// Renames the links and joints of a URDF, for several arms in one scene.
#pragma once

#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"

namespace cobot_command::arm {

/// Letters, digits, _, -, . and /, not starting with /, so that tf accepts the names.
[[nodiscard]] bool isNamePrefix(const std::string& text);

/// The URDF with `prefix` before the name of every link, joint and transmission, and before every reference
/// to them. The name of the robot and the materials do not change. Refused if the text is not XML with one
/// <robot>, or if the prefix is invalid.
[[nodiscard]] Result<std::string, ModelError> withPrefix(const std::string& urdf, const std::string& prefix);

}  // namespace cobot_command::arm
