// rapid check: all findings of the modules of a program.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/common/setting.h"
#include "cobot_command/rapid/source/dialect.h"

namespace cobot_command::tools {

struct CheckCommand {
  std::vector<std::string> files;
  rapid::Dialect dialect = rapid::Dialect::Irc5;
  std::string signals;  ///< a signal file; empty: none
  bool is_library = false;
  bool is_strict = false;
  bool is_json = false;
  std::vector<std::string> skipped;
};

/// Its options, bound to `command`.
[[nodiscard]] SettingTable checkTable(CheckCommand& command);

/// Prints the findings: as a compiler does, or as JSON. Returns the exit status: 0 if there are none, or only
/// warnings; 1 if there is an error or, when strict, a warning.
[[nodiscard]] int check(const CheckCommand& command);

}  // namespace cobot_command::tools
