// The grammar of one line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

/// Nothing for a blank line. The error tells the column and what was expected.
[[nodiscard]] Result<std::optional<Statement>, std::string> parseLine(std::string_view line);

/// true, empty, newline and the like.
[[nodiscard]] bool isConstant(std::string_view name);

}  // namespace cobot_command::tm_script
