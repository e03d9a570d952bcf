#include "library/declaration.h"

#include <array>
#include <cassert>
#include <optional>

#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

constexpr std::array<std::string_view, 6> kScalars{"byte", "int", "float", "double", "bool", "string"};

/// Cuts the prefix off, if it is there.
bool take(std::string_view& text, std::string_view prefix) {
  if (text.substr(0, prefix.size()) != prefix) return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Cuts the digits off at the front; 0 where there are none.
std::size_t takeNumber(std::string_view& text) {
  std::size_t number = 0;
  for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1)) {
    number = number * 10 + static_cast<std::size_t>(text.front() - '0');
  }
  return number;
}

Parameter takeType(std::string_view& text) {
  Parameter parameter;
  if (take(text, "any")) {
    parameter.kind = Parameter::Kind::Any;
  } else if (take(text, "number")) {
    parameter.kind = Parameter::Kind::Number;
  } else if (take(text, "element")) {
    parameter.kind = Parameter::Kind::Element;
  } else {
    std::size_t scalar = 0;
    while (scalar < kScalars.size() && !take(text, kScalars[scalar])) ++scalar;
    assert(scalar < kScalars.size());
    parameter.type.scalar = static_cast<ScalarType>(scalar);
  }
  parameter.type.is_array = take(text, "[");
  if (parameter.type.is_array) {
    parameter.length = takeNumber(text);
    take(text, "]");
  }
  return parameter;
}

/// [N ][literal ]type[?]
void takeParameter(std::string_view& text, Function& function) {
  const std::size_t count = takeNumber(text);
  take(text, " ");
  const bool is_literal = take(text, "literal ");
  Parameter parameter = takeType(text);
  parameter.is_literal = is_literal;
  const bool is_optional = take(text, "?");
  for (std::size_t i = 0; i < (count == 0 ? 1 : count); ++i) function.parameters.push_back(parameter);
  if (!is_optional) function.required = function.parameters.size();
}

std::string toText(const Parameter& parameter) {
  std::string text = parameter.kind == Parameter::Kind::Any       ? "any"
                     : parameter.kind == Parameter::Kind::Number  ? "number"
                     : parameter.kind == Parameter::Kind::Element ? "element"
                                                                  : toText(Type{parameter.type.scalar});
  if (!parameter.type.is_array) return text;
  return text + '[' + (parameter.length > 0 ? std::to_string(parameter.length) : "") + ']';
}

}  // namespace

Function readDeclaration(std::string_view declaration) {
  Function function;
  function.result = takeType(declaration);
  take(declaration, " ");
  const std::size_t bracket = declaration.find('(');
  assert(bracket != std::string_view::npos);
  function.name = std::string(declaration.substr(0, bracket));
  declaration.remove_prefix(bracket + 1);
  while (!declaration.empty() && declaration.front() != ')') {
    takeParameter(declaration, function);
    take(declaration, ", ");
  }
  assert(declaration == ")");
  return function;
}

std::string toText(const Function& function) {
  std::string text;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    if (i > 0) text += ", ";
    text += toText(function.parameters[i]);
    if (i >= function.required) text += '?';
  }
  return fmt::format("{}({})", function.name, text);
}

}  // namespace cobot_command::tm_script
