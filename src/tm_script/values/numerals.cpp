#include "values/numerals.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace cobot_command::tm_script {

namespace {

constexpr std::size_t kFloatDigits = 7;
constexpr const char* kDecimalDigits = "0123456789";

/// 16 or 2 when the text starts with 0x or 0b, which is then cut off; otherwise 10.
int takeBase(std::string_view& text) {
  if (text.size() < 2 || text[0] != '0') return 10;
  const int base = text[1] == 'x' || text[1] == 'X' ? 16 : text[1] == 'b' || text[1] == 'B' ? 2 : 10;
  if (base != 10) text.remove_prefix(2);
  return base;
}

Scalar integerLiteral(std::uint32_t bits) {
  if (bits <= std::numeric_limits<std::uint8_t>::max()) return static_cast<std::uint8_t>(bits);
  return static_cast<std::int32_t>(bits);
}

std::size_t significantDigits(std::string_view numeral) {
  std::size_t count = 0;
  std::size_t zeros = 0;  // since the last other digit: they count when one more follows
  for (const char c : numeral.substr(0, numeral.find_first_of("eE"))) {
    if (c == '.') continue;
    zeros = c == '0' ? zeros + 1 : 0;
    if (count > 0 || c != '0') ++count;
  }
  return count - std::min(count, zeros);
}

Scalar realLiteral(std::string_view numeral, double value) {
  const auto as_float = static_cast<float>(value);
  const bool in_range = value == 0 || (std::isnormal(as_float));
  if (significantDigits(numeral) <= kFloatDigits && in_range) return as_float;
  return value;
}

/// Of at most 15 digits and a point: whole number and power of ten are then doubles without error, so that
/// the quotient is the nearest double. A long trajectory is made of such numbers; a stream takes ten times as
/// long.
std::optional<double> parseShortReal(std::string_view text) {
  constexpr std::size_t kExactDigits = 15;
  std::uint64_t digits = 0;
  double power = 1;
  bool behind_point = false;
  if (text.size() > kExactDigits || text.find_first_of(kDecimalDigits) == std::string_view::npos) {
    return std::nullopt;
  }
  for (const char c : text) {
    if (c == '.' && !behind_point) {
      behind_point = true;
      continue;
    }
    if (c < '0' || c > '9') return std::nullopt;
    digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
    if (behind_point) power *= 10;
  }
  return static_cast<double>(digits) / power;
}

}  // namespace

std::optional<double> parseReal(std::string_view text) {
  if (const auto real = parseShortReal(text)) return real;
  if (text.find_first_not_of("0123456789.eE+-") != std::string_view::npos) return std::nullopt;
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0;
  stream >> std::noskipws >> value;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return value;
}

std::string textOfReal(double value, int digits) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream << std::uppercase << std::setprecision(digits) << value;
  return stream.str();
}

std::optional<std::uint32_t> parseDigits(std::string_view text, int base) {
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value, base);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

std::optional<double> numberIn(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
  std::string_view digits = text;
  const int base = takeBase(digits);
  if (base == 10) return parseReal(text);
  const auto bits = parseDigits(digits, base);
  if (!bits) return std::nullopt;
  return static_cast<std::int32_t>(*bits);
}

std::optional<Scalar> literalOf(std::string_view numeral) {
  std::string_view digits = numeral;
  const int base = takeBase(digits);
  if (base != 10) {
    const auto bits = parseDigits(digits, base);
    if (!bits) return std::nullopt;
    return integerLiteral(*bits);
  }
  if (numeral.find_first_not_of(kDecimalDigits) == std::string_view::npos) {
    const auto number = parseDigits(numeral, base);
    if (number && *number <= static_cast<std::uint32_t>(std::numeric_limits<std::int32_t>::max())) {
      return integerLiteral(*number);
    }
  }
  const auto value = parseReal(numeral);
  if (!value) return std::nullopt;
  return realLiteral(numeral, *value);
}

}  // namespace cobot_command::tm_script
