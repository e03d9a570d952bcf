// Tests that are worth repeating: a few rounds with every change, many with COBOT_TEST_THOROUGH set.
#pragma once

#include <cstdlib>

namespace cobot_command::testing {

[[nodiscard]] inline bool isThorough() {
  return std::getenv("COBOT_TEST_THOROUGH") != nullptr;
}

template <class Number>
[[nodiscard]] Number quickOrThorough(Number quick, Number thorough) {
  return isThorough() ? thorough : quick;
}

}  // namespace cobot_command::testing
