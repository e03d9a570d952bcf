// The files of a cell: the file written by the user, and the artifact built from it.
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

/// A file longer than `most` is refused too.
[[nodiscard]] Result<std::string, std::string> readFile(const std::string& name,
                                                        std::size_t most = kLongestFile);
/// Empty: the file was written completely, and replaced an existing one atomically. Otherwise the reasons why
/// not, for example: the existing object is no regular file, or is the source `made_of`.
[[nodiscard]] std::vector<std::string> writeFile(const std::string& name, const std::string& text,
                                                 const std::string& made_of = {});

/// Including the files that it names, which are next to it; or all its errors.
[[nodiscard]] Result<cell::Cell, std::vector<std::string>> readCellFile(const std::string& name);
[[nodiscard]] Result<cell::Artifact, std::vector<std::string>> readArtifact(const std::string& name);
/// Why the artifact does not belong to the cell of the file, or what is wrong with the file; a sentence.
[[nodiscard]] std::optional<std::string> objectionTo(const cell::Artifact& artifact,
                                                     const std::string& artifact_file,
                                                     const std::string& cell_file);

}  // namespace cobot_command::runtime
