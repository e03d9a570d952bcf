// A file that a goal names: on this machine, or in a package.
#pragma once

#include <cstddef>
#include <string>

#include "cobot_command/common/result.h"

namespace cobot_command::ros_adapter {

struct NamedFile {
  std::string name;  ///< for people
  std::string text;
};

/// `location`: an absolute path, or package://NAME/path; `field` of the goal it is. The error names the file.
[[nodiscard]] Result<NamedFile, std::string> readNamedFile(const char* field, const std::string& location,
                                                           std::size_t most_bytes);

}  // namespace cobot_command::ros_adapter
