// Reads a file that somebody named: a regular one, of a sane size, or a reason why not.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

/// All bytes of the file. The error says what there is in its place: nothing, a folder, a device, too much,
/// or what the system says. Nothing but regular files is opened, as that alone may have effects, or wait for
/// ever.
[[nodiscard]] Result<std::string, std::string> readRegularFile(const std::filesystem::path& path,
                                                               std::size_t size_limit);

}  // namespace cobot_command::ros_adapter
