// Cell files for tests, and what becomes of them.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/cell/program/cell_file.h"

namespace cobot_command::cell {

/// Section 2 of the specification, as it stands there.
extern const char* const kExample;
/// A cell that has each key of cell files at least once.
extern const char* const kFull;

/// The only file that cells of tests may name: "pick.yaml", a step in joints to T1 of kExample.
[[nodiscard]] Result<std::string, std::string> readTestFile(const std::string& name);

[[nodiscard]] Result<Cell, std::vector<Fault>> parsed(const std::string& text);
/// Of a text that is right; else the test fails, and the cell is empty.
[[nodiscard]] Cell cellOf(const std::string& text);
/// The faults of a text, a line each; "none".
[[nodiscard]] std::string faultsOf(const std::string& text);

/// `text` with its first `from`, which has to be there, replaced.
[[nodiscard]] std::string with(std::string text, const std::string& from, const std::string& to);
[[nodiscard]] std::string inFile(const std::string& path);

}  // namespace cobot_command::cell
