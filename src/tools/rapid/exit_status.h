// The exit statuses of rapid.
#pragma once

namespace cobot_command::tools {

inline constexpr int kDone = 0;
/// Errors, or what a check was to find.
inline constexpr int kFound = 1;

}  // namespace cobot_command::tools
