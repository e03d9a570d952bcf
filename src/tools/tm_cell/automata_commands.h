// The commands about automata as such: of cells, and of other programs.
#pragma once

#include <string>

#include "answer.h"

namespace cobot_command::tools {

/// Our figures beside those of a data file.
[[nodiscard]] Answer compareOracles(const std::string& file);
/// The automata of an artifact as text of that format: wmod, cif, dot or json; to a file, or to standard
/// output where none is named, and then nothing else.
[[nodiscard]] Answer exportAutomata(const std::string& artifact_file, const std::string& format,
                                    const std::string& output);
/// Synthesizes and verifies a problem of another program: .wmod, or our own JSON.
[[nodiscard]] Answer importAutomata(const std::string& file);

}  // namespace cobot_command::tools
