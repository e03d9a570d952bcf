// Boxes in the place of a mesh.
#pragma once

#include <string>

#include "answer.h"

namespace cobot_command::tools {

struct CoverOptions {
  std::string mesh;    ///< an STL file
  double cell = 50.0;  ///< edge of the cells that the boxes consist of [mm]
  double scale = 1.0;  ///< mm per unit of the file
  std::string output;  ///< a file; empty: standard output, and then nothing else
};

/// Boxes that cover it, as `shapes` of a cell file.
[[nodiscard]] Answer coverMesh(const CoverOptions& options);

}  // namespace cobot_command::tools
