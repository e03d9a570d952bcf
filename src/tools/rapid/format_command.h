// rapid format: a file in canonical form.
#pragma once

#include <string>

#include "cobot_command/common/setting.h"
#include "cobot_command/rapid/source/dialect.h"

namespace cobot_command::tools {

struct FormatOptions {
  std::string file;
  rapid::Dialect dialect = rapid::Dialect::Irc5;
  bool is_written = false;
  bool is_checked = false;
};

/// Its options, bound to `options`.
[[nodiscard]] SettingTable formatTable(FormatOptions& options);
/// What only the options together show to be wrong; empty if nothing is.
[[nodiscard]] std::string contradictionIn(const FormatOptions& options);

/// Prints the canonical form, writes it into the file, or checks whether the file has it. Returns the exit
/// status: 0; 1 if the file cannot be read, has a syntax error, cannot be written, or, when checked, is not
/// canonical.
[[nodiscard]] int format(const FormatOptions& options);

}  // namespace cobot_command::tools
