// How many points a path file has, so that nobody has to know that by heart.
#pragma once

#include <optional>
#include <string>

namespace cobot_command::rviz_plugin {

/// `location`: an absolute path, or package://NAME/path. Nothing: no such file can be read on this machine,
/// or it is no path.
[[nodiscard]] std::optional<int> countPoints(const std::string& location);

}  // namespace cobot_command::rviz_plugin
