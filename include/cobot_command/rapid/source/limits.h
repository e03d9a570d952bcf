// Limits of the source text. Beyond each of them is a finding, never a crash.
#pragma once

#include <cstddef>

namespace cobot_command::rapid {

inline constexpr std::size_t kMostFileBytes = std::size_t{16} << 20;  ///< E904
inline constexpr std::size_t kMostFindings = 100;                     ///< per file; E903
/// E219: brackets and signs within an expression, and, counted separately, instructions within instructions.
inline constexpr int kMostNesting = 200;
inline constexpr std::size_t kMostTextCharacters = 80;  ///< E104: of the value, without quotes and escapes

}  // namespace cobot_command::rapid
