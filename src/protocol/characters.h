// Bytes of the protocol, told apart without the locale, which <cctype> would ask.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace cobot_command::protocol {

[[nodiscard]] constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
[[nodiscard]] constexpr bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// 0..15, or 16 when it is no hexadecimal digit.
[[nodiscard]] constexpr unsigned hexValue(char c) {
  if (isDigit(c)) return static_cast<unsigned>(c - '0');
  if (c >= 'A' && c <= 'F') return static_cast<unsigned>(c - 'A') + 10;
  if (c >= 'a' && c <= 'f') return static_cast<unsigned>(c - 'a') + 10;
  return 16;
}

/// Script ids, and the transaction ids of the item stream: letters and digits.
[[nodiscard]] inline bool isAlphanumeric(std::string_view text) {
  return !text.empty() &&
         std::all_of(text.begin(), text.end(), [](char c) { return isLetter(c) || isDigit(c); });
}

/// A whole text of digits of the base, without sign, as an int; nothing when it is anything else.
[[nodiscard]] inline std::optional<int> parseDigits(std::string_view text, int base = 10) {
  int value = 0;
  if (text.empty() || text.front() == '-') return std::nullopt;
  const auto end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value, base);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

/// Cuts off and gives the part before the separator, which is dropped; all of the text where there is none.
[[nodiscard]] inline std::string_view takeUntil(char separator, std::string_view& text) {
  const std::size_t at = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return part;
}

}  // namespace cobot_command::protocol
