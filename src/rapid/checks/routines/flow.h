// Which instructions of a routine can be reached.
#pragma once

#include <cstdint>

namespace cobot_command::rapid {

/// The place before an instruction.
enum class Reach : std::uint8_t {
  Open,      ///< reached
  Closed,    ///< not reached: the next instruction is reported
  Reported,  ///< not reached, and reported
};

/// The place where two paths meet.
[[nodiscard]] constexpr Reach meet(Reach left, Reach right) {
  if (left == Reach::Open || right == Reach::Open) return Reach::Open;
  return left == Reach::Reported ? left : right;
}

/// The place after an instruction that nothing follows.
[[nodiscard]] constexpr Reach closed(Reach before) {
  return before == Reach::Open ? Reach::Closed : before;
}

}  // namespace cobot_command::rapid
