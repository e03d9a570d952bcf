// Numbers that distinguish the starts of nodes, and new journals.
#pragma once

#include <cstdint>

namespace cobot_command::runtime {

/// A random number above 0, different for each call.
[[nodiscard]] std::uint64_t anyId();

}  // namespace cobot_command::runtime
