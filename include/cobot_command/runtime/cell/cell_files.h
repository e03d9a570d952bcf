// The files of a cell: as people write them, and as they were built.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

[[nodiscard]] Result<std::string, std::string> readFile(const std::string& name);
/// Nothing: it was written wholly. Else why not.
[[nodiscard]] std::vector<std::string> writeFile(const std::string& name, const std::string& text);

/// With the files that it names beside it; or all that is wrong.
[[nodiscard]] Result<cell::Cell, std::vector<std::string>> readCellFile(const std::string& name);
[[nodiscard]] Result<cell::Artifact, std::vector<std::string>> readArtifact(const std::string& name);

}  // namespace cobot_command::runtime
