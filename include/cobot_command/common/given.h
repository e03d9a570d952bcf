// The value of a setting as received: a typed parameter, or the text of a command-line option.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace cobot_command {

/// A type that no setting accepts: a struct, a date, bytes. `name` names the type in messages.
struct OtherKind {
  std::string name;
};

struct Given;
using GivenList = std::vector<Given>;

struct Given {
  std::variant<bool, int, double, std::string, GivenList, OtherKind> value;
};

/// Text for messages: `5890.0`, `the text "abc"`, `a list of 3`. Long texts are truncated.
[[nodiscard]] std::string describe(const Given& given);
/// The text in quotes, for messages: without control characters, at most one line long.
[[nodiscard]] std::string quoted(const std::string& text);

}  // namespace cobot_command
