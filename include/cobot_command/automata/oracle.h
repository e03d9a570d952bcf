// Compares results of this package with those of independent programs for the same problems
// (cell-oracles.json).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"

namespace cobot_command::automata {

struct OracleFigure {
  std::string problem;
  std::string figure;  ///< its path in the file: "supervisor.fingerprint"
  std::string expected;
  std::string found;

  [[nodiscard]] bool isSame() const { return expected == found; }
};

/// One figure for each number and fingerprint that the file expects, except schedules, which cell/schedule
/// compares. A fault is a sentence.
[[nodiscard]] Result<std::vector<OracleFigure>, std::string> compareWithOracles(std::string_view file);

}  // namespace cobot_command::automata
