// What launch files and scripts want to know of an artifact, as plain text.
#pragma once

#include <string>

#include "answer.h"

namespace cobot_command::tools {

struct AskOptions {
  std::string artifact;
  std::string what;   ///< robots, mechanisms, model, home, or places
  std::string robot;  ///< or mechanism, of model, home and places
};

/// Prints the names of the robots, or of the mechanisms, with blanks between; the model of a robot; the
/// joints of its home in degrees, as a list in YAML; of a mechanism its position at home in m or rad; or the
/// places of a program.
[[nodiscard]] Answer askArtifact(const AskOptions& options);

}  // namespace cobot_command::tools
