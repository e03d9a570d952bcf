// RAPID files on disk: read, and replaced.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/common/result.h"
#include "cobot_command/rapid/source/source.h"

namespace cobot_command::tools {

/// The name of standard input on the command line.
inline constexpr const char* kStandardInput = "-";

/// A file, or standard input. A file that cannot be read is a source with the finding E901; of one that is
/// too long no more is read than is needed to see it (E904).
[[nodiscard]] rapid::Source readSourceFile(const std::string& name, const rapid::ReadOptions& options);

/// The bytes of a file, or of standard input, up to what a source may have and one more; or why it cannot be
/// read.
[[nodiscard]] Result<std::string, std::string> bytesOf(const std::string& name);

/// Replaces the content of an existing file, with its mode: the bytes are written to a new file in the same
/// folder, which then takes its place. So the file has its old or its new content at any time, also after a
/// crash or on a full disk. Links are followed. Returns the reason if the file is unchanged.
[[nodiscard]] std::optional<std::string> replaceFile(const std::string& name, std::string_view bytes);

}  // namespace cobot_command::tools
