// How values look in memory: flat runs of cells. A num and a bool are one cell, a string is kStringCells, a
// record or an array has its parts one after another, and a value that cannot be copied (clock, iodev ...) is
// one cell, a handle. So values are copied, kept and compared as memory, and own none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {

using Cell = float;
static_assert(sizeof(Cell) == 4);

/// A byte of length, and up to kMostTextCharacters bytes in ISO 8859-1. The rest is 0.
inline constexpr std::uint32_t kStringCells = 21;
static_assert(kStringCells * sizeof(Cell) > kMostTextCharacters);

/// A num as a cell: -0 becomes 0, so that equal values have equal cells.
[[nodiscard]] constexpr Cell numCell(float value) {
  return value + 0.0F;
}
[[nodiscard]] constexpr Cell boolCell(bool value) {
  return value ? 1.0F : 0.0F;
}
[[nodiscard]] constexpr bool isTrue(Cell cell) {
  return cell != 0.0F;
}

/// The bytes of a string, in ISO 8859-1. Valid as long as the cells are unchanged.
[[nodiscard]] std::string_view stringIn(const Cell* cells);
/// Precondition: at most kMostTextCharacters bytes, in ISO 8859-1.
void putString(std::string_view bytes, Cell* cells);

/// Equal values of one type. No cell is NaN: a result beyond single precision ends a program.
[[nodiscard]] inline bool areEqual(const Cell* left, const Cell* right, std::size_t cells) {
  return std::memcmp(left, right, cells * sizeof(Cell)) == 0;
}

/// UTF-8 to ISO 8859-1; std::nullopt if a character is not in it.
[[nodiscard]] std::optional<std::string> latin1(std::string_view utf8);
/// ISO 8859-1 to UTF-8.
[[nodiscard]] std::string utf8(std::string_view latin1);

}  // namespace cobot_command::rapid
