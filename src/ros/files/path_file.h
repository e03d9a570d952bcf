// The points of a path as a YAML file; config/path.yaml is one, and explains it.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

using PathPoints = std::vector<path::PathPoint>;

/// `location`: an absolute path, or package://NAME/path. The error names the file and the line.
[[nodiscard]] Result<PathPoints, std::string> readPathFile(const std::string& location);

/// `name` stands for the file in errors.
[[nodiscard]] Result<PathPoints, std::string> parsePath(const std::string& text, const std::string& name);

}  // namespace cobot_command::ros_adapter
