// Suggests the correct name for a misspelled one.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace cobot_command {

/// The known name with the fewest inserted, deleted, replaced or swapped letters: at most `most`, and a third
/// of the word. Empty if there is none.
[[nodiscard]] std::string nearestOf(std::string_view word, const std::vector<std::string>& known,
                                    std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace cobot_command
