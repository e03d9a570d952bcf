#include "cobot_command/rapid/source/literals.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <system_error>

#include <boost/locale/utf.hpp>

namespace cobot_command::rapid {

namespace {

/// Of `0x`, `0b`, `0o`; 10 for anything else.
int baseOf(std::string_view written) {
  if (written.size() < 2 || written[0] != '0') return 10;
  switch (written[1]) {
    case 'x':
    case 'X':
      return 16;
    case 'b':
    case 'B':
      return 2;
    case 'o':
    case 'O':
      return 8;
    default:
      return 10;
  }
}

/// std::from_chars reports too large and too small alike. The power of ten of the first digit that is not 0
/// decides which it is.
bool isSmall(std::string_view written) {
  const std::size_t exponent_sign = std::min(written.find_first_of("eE"), written.size());
  const std::string_view mantissa = written.substr(0, exponent_sign);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_not_of("0.");
  if (first == std::string_view::npos) return true;
  auto power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  if (exponent_sign < written.size()) {
    const std::string_view digits = written.substr(exponent_sign + 1);
    const bool is_negative = digits.front() == '-';
    const std::size_t skipped = is_negative || digits.front() == '+' ? 1 : 0;
    std::int64_t exponent = 0;
    const auto read = std::from_chars(digits.data() + skipped, digits.data() + digits.size(), exponent);
    if (read.ec != std::errc()) return is_negative;
    power += is_negative ? -exponent : exponent;
  }
  return power <= 0;
}

std::optional<float> decimalValue(std::string_view written) {
  const char* const end = written.data() + written.size();
  float value = 0;
  const auto read = std::from_chars(written.data(), end, value);
  if (read.ec == std::errc::result_out_of_range) {
    return isSmall(written) ? std::optional(0.0F) : std::nullopt;
  }
  return read.ec == std::errc() && read.ptr == end && std::isfinite(value) ? std::optional(value)
                                                                           : std::nullopt;
}

int digitValue(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'z') return c - 'a' + 10;
  return c >= 'A' && c <= 'Z' ? c - 'A' + 10 : std::numeric_limits<int>::max();
}

std::optional<float> wholeValue(std::string_view digits, int base) {
  double value = 0;
  for (const char c : digits) {
    const int digit = digitValue(c);
    if (digit >= base) return std::nullopt;
    value = value * base + digit;
  }
  const bool fits = !digits.empty() && value <= std::numeric_limits<float>::max();
  return fits ? std::optional(static_cast<float>(value)) : std::nullopt;
}

}  // namespace

std::optional<float> numberValue(std::string_view written) {
  const int base = baseOf(written);
  return base == 10 ? decimalValue(written) : wholeValue(written.substr(2), base);
}

std::string textValue(std::string_view written) {
  std::string value;
  if (!written.empty()) written.remove_prefix(1);
  for (std::size_t i = 0; i < written.size(); ++i) {
    const char c = written[i];
    const char next = i + 1 < written.size() ? written[i + 1] : '\0';
    if (c == '"' && next != '"') break;
    const bool is_code =
        c == '\\' && i + 2 < written.size() && digitValue(next) < 16 && digitValue(written[i + 2]) < 16;
    if (is_code) {
      const auto code = static_cast<unsigned>(16 * digitValue(next) + digitValue(written[i + 2]));
      boost::locale::utf::utf_traits<char>::encode(code, std::back_inserter(value));
      i += 2;
    } else {
      value += c;
      const bool is_doubled = (c == '"' || c == '\\') && next == c;
      if (is_doubled) ++i;
    }
  }
  return value;
}

}  // namespace cobot_command::rapid
