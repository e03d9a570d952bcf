// What can stand as the name of a base or TCP of the controller's project.
#pragma once

#include <cstddef>
#include <string_view>

namespace cobot_command {

inline constexpr std::size_t kLongestProjectName = 255;  // [bytes]

/// UTF-8, not empty, without control characters (a line end would begin another command), not too long.
/// Quotes are allowed: scripts double them.
[[nodiscard]] bool isProjectName(std::string_view name);

}  // namespace cobot_command
