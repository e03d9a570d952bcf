// Compares the schedules of this package with those of independent programs for the same problems
// (cell-oracles.json).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/automata/oracle.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

/// One figure for each figure of the file's schedules; times in seconds. A fault is a sentence.
[[nodiscard]] Result<std::vector<automata::OracleFigure>, std::string> compareSchedulesWithOracles(
    std::string_view file);

}  // namespace cobot_command::cell
