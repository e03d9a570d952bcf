// Numbers by which starts of nodes, and new journals, are told from each other.
#pragma once

#include <cstdint>

namespace cobot_command::runtime {

/// Drawn at random, above 0: another one each time.
[[nodiscard]] std::uint64_t anyId();

}  // namespace cobot_command::runtime
