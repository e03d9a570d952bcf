#include "values/conversion.h"

#include <cmath>

#include "values/numerals.h"
#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::tm_script {

namespace {

using Converted = Result<Scalar, std::string>;

Scalar fromInteger(std::int32_t number, ScalarType to) {
  switch (to) {
    case ScalarType::Byte:
      return static_cast<std::uint8_t>(number);
    case ScalarType::Float:
      return static_cast<float>(number);
    case ScalarType::Double:
      return static_cast<double>(number);
    default:
      return number;
  }
}

Converted fromReal(double number, ScalarType to) {
  if (to == ScalarType::Double) return Scalar(number);
  if (to == ScalarType::Float) return Scalar(static_cast<float>(number));
  const double whole = std::trunc(number);
  if (!(whole >= -2147483648.0 && whole <= 2147483647.0)) {
    return refuse(fmt::format("{} is no number that an int holds", textOf(Scalar(number))));
  }
  return fromInteger(static_cast<std::int32_t>(whole), to);
}

Converted fromText(const std::string& text, ScalarType to) {
  if (to == ScalarType::Bool) return Scalar(!text.empty());
  const auto number = numberIn(text);
  if (!number) return refuse(fmt::format("\"{}\" is no number", text.substr(0, 32)));
  return fromReal(*number, to);
}

}  // namespace

Conversion conversionOf(Type from, Type to) {
  if (from.is_array != to.is_array) return Conversion::None;
  if (from.scalar == to.scalar) return Conversion::Same;
  if (from.scalar == ScalarType::String || to.scalar == ScalarType::String) return Conversion::Text;
  if (!isNumber(from.scalar) || !isNumber(to.scalar)) return Conversion::None;
  const bool narrows = isInteger(to.scalar) && from.scalar > to.scalar;
  return narrows ? Conversion::Narrowing : Conversion::Widening;
}

Converted convert(const Scalar& scalar, ScalarType to) {
  if (typeOf(scalar) == to) return scalar;
  if (conversionOf({typeOf(scalar)}, {to}) == Conversion::None) {
    return refuse(fmt::format("a {} is no {}", toText(Type{typeOf(scalar)}), toText(Type{to})));
  }
  if (to == ScalarType::String) return Scalar(textOf(scalar));
  return std::visit(Overloaded{[&](const std::string& text) { return fromText(text, to); },
                               [&](float number) { return fromReal(number, to); },
                               [&](double number) { return fromReal(number, to); },
                               [&](auto integer) -> Converted { return fromInteger(integer, to); }},
                    scalar);
}

Result<Value, std::string> convert(const Value& value, Type to) {
  if (typeOf(value) == to) return value;
  if (const auto* scalar = std::get_if<Scalar>(&value); scalar && !to.is_array) {
    auto converted = convert(*scalar, to.scalar);
    if (!converted) return refuse(std::move(converted.error()));
    return Value(std::move(*converted));
  }
  const auto* array = std::get_if<Array>(&value);
  if (!array || !to.is_array) return refuse(fmt::format("{} is no {}", toText(typeOf(value)), toText(to)));
  Array items{to.scalar, {}};
  items.items.reserve(array->items.size());
  for (const Scalar& item : array->items) {
    auto converted = convert(item, to.scalar);
    if (!converted) return refuse(std::move(converted.error()));
    items.items.push_back(std::move(*converted));
  }
  return Value(std::move(items));
}

Value initialValue(Type type) {
  if (type.is_array) return Array{type.scalar, {}};
  if (type.scalar == ScalarType::String) return Scalar(std::string());
  if (type.scalar == ScalarType::Bool) return Scalar(false);
  return Scalar(fromInteger(0, type.scalar));
}

}  // namespace cobot_command::tm_script
