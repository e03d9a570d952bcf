// Several arms in one world: the same URDF under other names.
#pragma once

#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"

namespace cobot_command::arm {

/// Letters, digits, _, -, . and /, not beginning with /, so that tf takes the names.
[[nodiscard]] bool isNamePrefix(const std::string& text);

/// The URDF with `prefix` before the name of every link, joint and transmission and before every mention of
/// them; the robot's own name and the materials stay. Refused when the text is not XML with
/// one <robot>, or the prefix is none.
[[nodiscard]] Result<std::string, ModelError> withPrefix(const std::string& urdf, const std::string& prefix);

}  // namespace cobot_command::arm
