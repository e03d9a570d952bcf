// The URDFs of urdf/, as text inside the library; the source file is made by cmake/EmbedUrdf.cmake.
#pragma once

#include <string>
#include <vector>

namespace cobot_command::arm {

struct EmbeddedUrdf {
  std::string name;
  std::string text;
};

[[nodiscard]] const std::vector<EmbeddedUrdf>& embeddedUrdfs();

}  // namespace cobot_command::arm
