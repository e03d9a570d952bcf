// Values of the TM script language and their types (I848-E-03 chapter 1).
//
// Texts are bytes, meant to be UTF-8. Arrays have one dimension, and all items have the same type.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace cobot_command::tm_script {

/// In the order of the alternatives of Scalar. The numeric types are first, from the narrowest to the widest.
enum class ScalarType { Byte, Int, Float, Double, Bool, String };

struct Type {
  ScalarType scalar = ScalarType::Int;
  bool is_array = false;

  friend bool operator==(Type a, Type b) { return a.scalar == b.scalar && a.is_array == b.is_array; }
  friend bool operator!=(Type a, Type b) { return !(a == b); }
};

using Scalar = std::variant<std::uint8_t, std::int32_t, float, double, bool, std::string>;

struct Array {
  ScalarType element = ScalarType::Byte;
  std::vector<Scalar> items;  ///< each of the type `element`

  friend bool operator==(const Array& a, const Array& b) {
    return a.element == b.element && a.items == b.items;
  }
  friend bool operator!=(const Array& a, const Array& b) { return !(a == b); }
};

using Value = std::variant<Scalar, Array>;

/// Largest array that the manual allows.
inline constexpr std::size_t kMaxElements = 2048;
/// Limit of one text, or of all texts of one array. Chosen by this package, so that a script cannot exhaust
/// the memory.
inline constexpr std::size_t kMaxValueBytes = 65536;

[[nodiscard]] inline ScalarType typeOf(const Scalar& scalar) {
  return static_cast<ScalarType>(scalar.index());
}
[[nodiscard]] Type typeOf(const Value& value);
[[nodiscard]] constexpr bool isInteger(ScalarType type) {
  return type <= ScalarType::Int;
}
[[nodiscard]] constexpr bool isNumber(ScalarType type) {
  return type <= ScalarType::Double;
}
[[nodiscard]] constexpr bool isNumber(Type type) {
  return !type.is_array && isNumber(type.scalar);
}

/// As in declarations: "int", "float[]".
[[nodiscard]] std::string toText(Type type);

/// Approximate size in memory [bytes].
[[nodiscard]] std::size_t sizeOf(const Value& value);

/// Converts a value to text as the language does: 7 digits of a float and 15 of a double without trailing
/// zeros, True and False, {1,2,3}; texts without quotes.
[[nodiscard]] std::string textOf(const Scalar& scalar);
[[nodiscard]] std::string textOf(const Value& value);

}  // namespace cobot_command::tm_script
