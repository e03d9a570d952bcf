// The file that keeps the tables: read at the start, and replaced as a whole when one of them is written.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

/// All of it; nothing: there is no such file yet. The error says why it cannot be read.
[[nodiscard]] Result<std::optional<std::string>, std::string> readTablesFile(const std::string& path);

/// Nothing when it could be replaced now; tried with a file beside it, which is gone again.
[[nodiscard]] std::optional<std::string> whyNotWritable(const std::string& path);

/// Nothing when it was done: the new text is on the disk, and at no moment there was less than the old or
/// the new one. A link stays a link. May take as long as the disk does.
[[nodiscard]] std::optional<std::string> writeTablesFile(const std::string& path, const std::string& text);

}  // namespace cobot_command::ros_adapter
