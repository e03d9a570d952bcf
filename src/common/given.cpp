#include "cobot_command/common/given.h"

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command {

std::string quoted(const std::string& text) {
  return '"' + foreignText(text, kQuoteLimit) + '"';
}

namespace {

/// With a decimal point, so that nobody takes it for a whole number; fmt's own '#' leaves the 0 out from
/// version 10 on.
std::string describeReal(double number) {
  std::string text = fmt::format("{}", number);
  const bool is_whole = text.find_first_not_of("-0123456789") == std::string::npos;
  return is_whole ? text + ".0" : text;
}

}  // namespace

std::string describe(const Given& given) {
  return std::visit(Overloaded{[](bool flag) { return std::string(flag ? "true" : "false"); },
                               [](int number) { return std::to_string(number); },
                               [](double number) { return describeReal(number); },
                               [](const std::string& text) {
                                 return text.empty() ? std::string("an empty text")
                                                     : "the text " + quoted(text);
                               },
                               [](const GivenList& list) { return fmt::format("a list of {}", list.size()); },
                               [](const OtherKind& other) { return other.name; }},
                    given.value);
}

}  // namespace cobot_command
