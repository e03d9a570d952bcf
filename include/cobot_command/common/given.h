// The value of a setting as somebody gave it: a typed parameter, or the text of an option.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace cobot_command {

/// What no setting can be: a struct, a date, bytes. `name` says which, for messages.
struct OtherKind {
  std::string name;
};

struct Given;
using GivenList = std::vector<Given>;

struct Given {
  std::variant<bool, int, double, std::string, GivenList, OtherKind> value;
};

/// In words, for messages: `5890.0`, `the text "abc"`, `a list of 3`. Long texts are cut.
[[nodiscard]] std::string describe(const Given& given);
/// A text in quotes for messages: without control characters, and not longer than a line.
[[nodiscard]] std::string quoted(const std::string& text);

}  // namespace cobot_command
