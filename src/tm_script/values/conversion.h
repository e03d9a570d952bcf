// From one type to another (I848-E-03 1.5 and 1.6).
#pragma once

#include <string>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// From the best to the worst; overloads are chosen by it.
enum class Conversion {
  Same,
  Widening,   ///< byte -> int -> float -> double, and double -> float
  Narrowing,  ///< a real to an integer, an int to a byte
  Text,       ///< between a text and something else
  None
};

/// An array is converted item by item.
[[nodiscard]] Conversion conversionOf(Type from, Type to);
/// Does the controller warn of it?
[[nodiscard]] constexpr bool isWarned(Conversion conversion) {
  return conversion == Conversion::Narrowing || conversion == Conversion::Text;
}

/// Fails for Conversion::None, for a text that is no number, and for a real that no int holds.
[[nodiscard]] Result<Scalar, std::string> convert(const Scalar& scalar, ScalarType to);
[[nodiscard]] Result<Value, std::string> convert(const Value& value, Type to);

/// A declared variable without an initial value: 0, false, "" or no elements.
[[nodiscard]] Value initialValue(Type type);

}  // namespace cobot_command::tm_script
