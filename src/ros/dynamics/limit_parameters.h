// The parameter of the software limits that rule from the start of the node on.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/command/dynamics.h"
#include "cobot_command/common/setting.h"

namespace cobot_command::ros_adapter {

/// Of the list of texts; `texts` outlives it.
[[nodiscard]] Setting limitsRow(std::vector<std::string>& texts);

/// What they come to, for joints that are not named those of the model; nothing where there are none. `arm`:
/// nullptr without a model.
[[nodiscard]] std::optional<SettingFault> readLimits(const std::vector<std::string>& texts,
                                                     const arm::ArmModel* arm,
                                                     std::optional<command::SoftwareLimits>& limits);

}  // namespace cobot_command::ros_adapter
