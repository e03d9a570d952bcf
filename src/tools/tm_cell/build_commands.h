// The commands that make an artifact of a cell file, or look at one.
#pragma once

#include <string>

#include "answer.h"

#include "cobot_command/cell/artifact/cell_build.h"

namespace cobot_command::tools {

struct BuildOptions {
  std::string cell_file;
  std::string output;  ///< empty: nothing is written
  cell::Policy policy = cell::Policy::Supervisor;
  unsigned threads = 1;
};

/// Reads the file, and nothing more.
[[nodiscard]] Answer checkCell(const std::string& cell_file);
/// All stages up to that one.
[[nodiscard]] Answer buildCell(const BuildOptions& options, cell::BuildStage last);
/// Whether an artifact is proved, and of that cell file where one is named.
[[nodiscard]] Answer verifyArtifact(const std::string& artifact_file, const std::string& cell_file,
                                    unsigned threads);

}  // namespace cobot_command::tools
