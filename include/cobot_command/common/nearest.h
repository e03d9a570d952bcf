// Suggests the correct name for a misspelled one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cobot_command {

/// The known name with the fewest inserted, deleted, replaced or swapped letters; empty if none is close.
[[nodiscard]] std::string nearestOf(std::string_view word, const std::vector<std::string>& known);

}  // namespace cobot_command
