// Programs of a few lines, checked, and their findings as text.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/rapid/checks/check.h"

namespace cobot_command::rapid {

/// One file.
[[nodiscard]] CheckedProgram checkedText(const std::string& text, const CheckOptions& options = {},
                                         Dialect dialect = Dialect::Irc5);
/// "E401 3:5" of each finding of a file.
[[nodiscard]] std::vector<std::string> idsAndPlaces(const Source& source,
                                                    const std::vector<Finding>& findings);
/// Of `lines` in main() of a module that begins with `declarations`; the first line is line 3, and one more
/// for each declaration.
[[nodiscard]] std::vector<std::string> findingsInMain(const std::string& lines,
                                                      const std::string& declarations = "");
/// The text of such a module.
[[nodiscard]] std::string withMain(const std::string& lines, const std::string& declarations = "");

}  // namespace cobot_command::rapid
