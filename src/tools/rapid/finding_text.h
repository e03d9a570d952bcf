// Findings as a compiler prints them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/rapid/source/source.h"

namespace cobot_command::tools {

/// Three lines:
///
///   robot.mod:12:7: error E202: ';' is missing
///       ok:=2
///            ^
///
/// The last two are missing if the line is empty. A long line is shown around the finding. `file` is treated
/// as foreign text, as the line is.
[[nodiscard]] std::vector<std::string> findingLines(const rapid::Source& source,
                                                    const rapid::Finding& finding, std::string_view file);

}  // namespace cobot_command::tools
