// Tests that are worth repeating: a few rounds with every change, many with COBOT_TEST_THOROUGH set; other
// seeds, and other counts, with variables of their own.
#pragma once

#include <cstdlib>

namespace cobot_command::testing {

[[nodiscard]] inline bool isThorough() {
  return std::getenv("COBOT_TEST_THOROUGH") != nullptr;
}

/// The number that a variable of the environment has.
[[nodiscard]] inline unsigned fromEnvironment(const char* name, unsigned fallback) {
  const char* const value = std::getenv(name);
  return value == nullptr ? fallback : static_cast<unsigned>(std::strtoul(value, nullptr, 10));
}

template <class Number>
[[nodiscard]] Number quickOrThorough(Number quick, Number thorough) {
  return isThorough() ? thorough : quick;
}

}  // namespace cobot_command::testing
