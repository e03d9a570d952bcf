// The file of a cell: text → Cell, or all that is wrong with it. Pure: who calls reads the files.
//
// What can be told without planning is checked here: keys, names, types, ranges, the rules of the blocks, the
// graphs of programs, what is carried and which frames are active at each station. A path whose last motion
// has joints as its target has to end at its station. Left to the planning of the cell: steps that cannot be
// planned, and ends that only a plan knows (section 2 of cell.md, M4).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cobot_command/cell/program/cell.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// What is wrong with a cell file: bounded texts without control characters.
struct Fault {
  std::string file;
  int line = 0;         ///< from 1; 0: it is not known. Behind an alias: of what the alias stands for
  int column = 0;       ///< from 1, in characters; 0: it is not known
  std::string field;    ///< "programs.RA[0].steps[2].speed"; empty: the file as a whole
  std::string found;    ///< `is "fast"`
  std::string allowed;  ///< "a whole number"; empty: there is nothing to be said
  std::string advice;   ///< what to do
};
/// "cell.yaml:12:5: programs.RA[0].steps[2].speed is "fast"; allowed: a whole number; write what is allowed"
[[nodiscard]] std::string describe(const Fault& fault);

/// The text of a file that a cell file names (`steps_file`), with the name as it stands there; or why it
/// cannot be read. Never empty: who reads no files refuses them all.
using ReadFile = std::function<Result<std::string, std::string>(const std::string& name)>;

/// `name`: of the file, for faults. The faults: at least one, at most a hundred, in the order of their lines.
[[nodiscard]] Result<Cell, std::vector<Fault>> parseCell(const std::string& text, const std::string& name,
                                                         const ReadFile& read_file);

}  // namespace cobot_command::cell
