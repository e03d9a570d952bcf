// Checks the syntax of a host name or address. Does not check whether the host exists.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

namespace cobot_command {

inline constexpr std::size_t kMaxHostLength = 255;

[[nodiscard]] inline bool isHostName(const std::string& text) {
  return !text.empty() && text.size() <= kMaxHostLength &&
         std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < '\x7f'; });
}

}  // namespace cobot_command
