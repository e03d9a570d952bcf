// Zones and claims as files for viewers.
#pragma once

#include <string>

#include "answer.h"

namespace cobot_command::tools {

struct VoxelsOptions {
  std::string cell_file;
  std::string folder;          ///< is made where there is none
  std::string format = "ply";  ///< ply or bt
  unsigned threads = 1;
};

/// A file of each zone and of the whole claim of each robot and mechanism, as a build has them.
[[nodiscard]] Answer writeVoxels(const VoxelsOptions& options);

}  // namespace cobot_command::tools
