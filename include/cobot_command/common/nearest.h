// The name that a misspelt one was meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobot_command {

/// The known name with the fewest letters to add, drop, change or swap; empty when none is close.
[[nodiscard]] std::string nearestOf(std::string_view word, const std::vector<std::string>& known);

}  // namespace cobot_command
