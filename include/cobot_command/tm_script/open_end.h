// What a script leaves open, so that lines behind it would be read as part of it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cobot_command::tm_script {

/// The first of them in words, with its line: a text that its line does not close, a comment or a bracket
/// that the script does not close. Nothing: what follows on a line of its own is read by itself. Nothing else
/// is checked.
[[nodiscard]] std::optional<std::string> openEndOf(std::string_view script);

}  // namespace cobot_command::tm_script
