// Numbers as they are written, whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// Digits with a point, an exponent or neither: "12", "-.5", "3.4e5". Nothing for other texts and for what no
/// double holds.
[[nodiscard]] std::optional<double> parseReal(std::string_view text);

/// So many significant digits at most, without needless zeros; with an exponent where that is shorter: 417.5,
/// 1E+10.
[[nodiscard]] std::string textOfReal(double value, int digits);

/// Digits of the base 2, 10 or 16, without sign or prefix. More than 32 bits are nothing.
[[nodiscard]] std::optional<std::uint32_t> parseDigits(std::string_view text, int base);

/// A number in a text as the language reads it: decimal, 0x or 0b, with a sign, blanks around it.
[[nodiscard]] std::optional<double> numberIn(std::string_view text);

/// The narrowest type that holds the numeral: 100 is a byte, 1000 an int, 1.11 a float, 0.123456789 a double.
[[nodiscard]] std::optional<Scalar> literalOf(std::string_view numeral);

}  // namespace cobot_command::tm_script
