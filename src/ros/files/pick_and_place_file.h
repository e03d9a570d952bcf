// The steps of a pick-and-place cycle as a YAML file; config/pick_and_place.yaml is one, and explains it.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

using PickAndPlaceSteps = std::vector<blocks::PickAndPlaceStep>;

/// `location`: an absolute path, or package://NAME/path. The error names the file and the line.
[[nodiscard]] Result<PickAndPlaceSteps, std::string> readPickAndPlaceFile(const std::string& location);

/// `name` stands for the file in errors.
[[nodiscard]] Result<PickAndPlaceSteps, std::string> parsePickAndPlace(const std::string& text,
                                                                       const std::string& name);

}  // namespace cobot_command::ros_adapter
