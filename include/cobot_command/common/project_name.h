// Valid names of a base or TCP in the controller's project.
#pragma once

#include <cstddef>
#include <string_view>

namespace cobot_command {

inline constexpr std::size_t kLongestProjectName = 255;  // [bytes]

/// UTF-8, not empty, at most kLongestProjectName bytes, without control characters (a line end would start
/// another command). Quotes are allowed: scripts double them.
[[nodiscard]] bool isProjectName(std::string_view name);

}  // namespace cobot_command
