// Values of the format STRING: `12.5`, `true`, `"text"`, `{1,2,3}`.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "item_json.h"

namespace cobot_command::protocol {

/// In quotes; those within are doubled, as in a script.
[[nodiscard]] std::string inQuotes(std::string_view text);

/// Cuts off and gives the part before the first `separator` that stands in no quotes; the separator is
/// dropped. All of the text where there is none.
[[nodiscard]] std::string_view takeUnquoted(std::string_view separator, std::string_view& text);

/// The same value as JSON; nothing when it is none.
[[nodiscard]] std::optional<JsonTree> readStringValue(std::string_view text);

}  // namespace cobot_command::protocol
