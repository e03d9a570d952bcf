#include "cobot_command/tm_script/value.h"

#include <cmath>

#include "values/numerals.h"

#include "cobot_command/common/overloaded.h"

namespace cobot_command::tm_script {

namespace {

/// As .NET writes numbers, in which the controller is made.
std::string controllerText(double value, int digits) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  return textOfReal(value == 0 ? 0.0 : value, digits);
}

std::size_t sizeOf(const Scalar& scalar) {
  constexpr std::size_t kSizes[] = {1, 4, 4, 8, 1};
  if (const auto* text = std::get_if<std::string>(&scalar)) return text->size();
  return kSizes[scalar.index()];
}

}  // namespace

Type typeOf(const Value& value) {
  return std::visit(Overloaded{[](const Scalar& scalar) {
                                 return Type{typeOf(scalar), false};
                               },
                               [](const Array& array) {
                                 return Type{array.element, true};
                               }},
                    value);
}

std::string toText(Type type) {
  constexpr const char* kNames[] = {"byte", "int", "float", "double", "bool", "string"};
  return std::string(kNames[static_cast<std::size_t>(type.scalar)]) + (type.is_array ? "[]" : "");
}

std::size_t sizeOf(const Value& value) {
  if (const auto* scalar = std::get_if<Scalar>(&value)) return sizeOf(*scalar);
  std::size_t bytes = 0;
  for (const Scalar& item : std::get<Array>(value).items) bytes += sizeOf(item);
  return bytes;
}

std::string textOf(const Scalar& scalar) {
  return std::visit(Overloaded{[](const std::string& text) { return text; },
                               [](bool flag) { return std::string(flag ? "True" : "False"); },
                               [](float number) { return controllerText(number, 7); },
                               [](double number) { return controllerText(number, 15); },
                               [](auto integer) { return std::to_string(integer); }},
                    scalar);
}

std::string textOf(const Value& value) {
  if (const auto* scalar = std::get_if<Scalar>(&value)) return textOf(*scalar);
  std::string text = "{";
  for (const Scalar& item : std::get<Array>(value).items) {
    if (text.size() > 1) text += ',';
    text += textOf(item);
  }
  return text + '}';
}

}  // namespace cobot_command::tm_script
