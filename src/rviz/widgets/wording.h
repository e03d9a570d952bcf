// Words for the numbers of enumerations in messages.
#pragma once

#include <array>
#include <cstddef>

namespace cobot_command::rviz_plugin {

/// Also for a number that a newer node may send.
template <std::size_t N>
[[nodiscard]] const char* wordFor(const std::array<const char*, N>& words, std::size_t number) {
  return number < N ? words[number] : "unknown";
}

}  // namespace cobot_command::rviz_plugin
