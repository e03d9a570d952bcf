// The files of a cell: as people write them, and as they were built.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::runtime {

inline constexpr std::size_t kLongestFile = std::size_t{1} << 30;  // [bytes]

/// Refused, too: it is longer than `most`.
[[nodiscard]] Result<std::string, std::string> readFile(const std::string& name,
                                                        std::size_t most = kLongestFile);
/// Nothing: it was written wholly, and takes the place of one that there was, at once. Else why not: what
/// there is is no file, or is the one that it was made of.
[[nodiscard]] std::vector<std::string> writeFile(const std::string& name, const std::string& text,
                                                 const std::string& made_of = {});

/// With the files that it names beside it; or all that is wrong.
[[nodiscard]] Result<cell::Cell, std::vector<std::string>> readCellFile(const std::string& name);
[[nodiscard]] Result<cell::Artifact, std::vector<std::string>> readArtifact(const std::string& name);
/// Why the artifact is of another cell than that of the file, or what is wrong with that; a sentence.
[[nodiscard]] std::optional<std::string> objectionTo(const cell::Artifact& artifact,
                                                     const std::string& artifact_file,
                                                     const std::string& cell_file);

}  // namespace cobot_command::runtime
