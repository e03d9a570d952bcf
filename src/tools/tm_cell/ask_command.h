// What launch files and scripts want to know of an artifact, as plain text.
#pragma once

#include <string>

#include "answer.h"

namespace cobot_command::tools {

struct AskOptions {
  std::string artifact;
  std::string what;   ///< robots, mechanisms, speed, model, urdf, tcp, home, or places
  std::string robot;  ///< or mechanism, of model, urdf, tcp, home and places
};

/// Prints the names of the robots, or of the mechanisms, with blanks between; the highest project speed for
/// which the cell was proved [%]; of a robot its model, its URDF, or its TCP at home [mm, deg]; the joints of
/// its home in degrees, as a list in YAML; of a mechanism its position at home in m or rad; or the places of
/// a program.
[[nodiscard]] Answer askArtifact(const AskOptions& options);

}  // namespace cobot_command::tools
