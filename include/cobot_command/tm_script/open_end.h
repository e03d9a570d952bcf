// Finds unclosed parts of a script, which would extend into the lines after it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cobot_command::tm_script {

/// Describes the first one, with its line: a text that is not closed on its line, or a comment or a bracket
/// that the script does not close. std::nullopt: lines added after the script are parsed separately. Nothing
/// else is checked.
[[nodiscard]] std::optional<std::string> openEndOf(std::string_view script);

}  // namespace cobot_command::tm_script
