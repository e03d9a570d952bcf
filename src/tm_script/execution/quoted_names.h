// Variables in single quotes inside a text: "Hi, 's' Robot" (I848-E-03 1.2). The controller replaces them,
// and warns.
#pragma once

#include <string>
#include <string_view>

namespace cobot_command::tm_script {

/// Replaces each 'name' for which `value_of(name)` gives a text (a std::optional<std::string>).
template <class ValueOf>
[[nodiscard]] std::string withQuotedNames(std::string_view text, ValueOf&& value_of) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '\'' ? text.find('\'', at + 1) : std::string_view::npos;
    const auto value = end == std::string_view::npos ? decltype(value_of(text)){}
                                                     : value_of(text.substr(at + 1, end - at - 1));
    if (value) {
      result += *value;
    } else {
      result += text[at];
    }
    at = value ? end + 1 : at + 1;
  }
  return result;
}

}  // namespace cobot_command::tm_script
