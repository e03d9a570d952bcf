// Tests that are worth repeating: a few rounds with every change, many with COBOT_TEST_THOROUGH set; other
// seeds, and other counts, with variables of their own.
#pragma once

#include <cstddef>
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

/// A tenth of the rounds of a long test in the quick form of scripts/test, whose rooms are watched by
/// sanitizers; all of them in every other build, `scripts/test --sanitize address` among them.
template <class Number>
[[nodiscard]] Number tenthWhenWatched(Number rounds) {
#ifdef COBOT_WATCHED
  return isThorough() ? rounds : rounds / Number{10};
#else
  return rounds;
#endif
}

/// The step through a long list of cases, of which every tenth is tried when watched.
[[nodiscard]] inline std::size_t strideWhenWatched() {
  return 10 / tenthWhenWatched(std::size_t{10});
}

template <class Number>
[[nodiscard]] Number quickOrThorough(Number quick, Number thorough) {
  return isThorough() ? thorough : quick;
}

}  // namespace cobot_command::testing
