// Reads the text of a cell file into a Cell, or returns all its faults. Pure: the caller reads the files.
//
// Everything that needs no planning is checked here: keys, names, types, ranges, the rules of the blocks, the
// graphs of programs, the carried parts and active frames at each station. A path whose last motion has a
// joint target must end at its station. The planning of the cell checks the rest: steps that cannot be
// planned, and ends that only a plan determines (doc/cell.md).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// A fault of a cell file: bounded texts without control characters.
struct Fault {
  std::string file;
  int line = 0;         ///< from 1; 0: unknown. For an alias: of its anchor
  int column = 0;       ///< from 1, in characters; 0: unknown
  std::string field;    ///< "programs.RA[0].steps[2].speed"; empty: the file as a whole
  std::string found;    ///< `is "fast"`
  std::string allowed;  ///< "a whole number"; empty: not applicable
  std::string advice;   ///< what to do
};
/// "cell.yaml:12:5: programs.RA[0].steps[2].speed is "fast"; allowed: a whole number; write what is allowed"
[[nodiscard]] std::string describe(const Fault& fault);

/// Returns the text of a file that a cell file names (`steps_file`), or why it cannot be read. `name` is as
/// written there. Must not be empty: a caller that reads no files refuses all of them.
using ReadFile = std::function<Result<std::string, std::string>(const std::string& name)>;

/// `name`: of the file, for faults. On error at least one fault and at most a hundred, in the order of their
/// lines.
[[nodiscard]] Result<Cell, std::vector<Fault>> parseCell(const std::string& text, const std::string& name,
                                                         const ReadFile& read_file);

}  // namespace cobot_command::cell
