// What the supervisors of a cell keep out of, in words for people: rules over few robots and their places
// (cell.md, S4).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/model/supervisors.h"

namespace cobot_command::cell {

struct PartRules {
  std::vector<std::string> robots;  ///< by their names; mechanisms too
  /// "not RA with Z1 (W>1) while RB with Z2 (W>1)", each, with the places at which they hold that; none:
  /// the zones alone are enough.
  std::vector<std::string> rules;
  std::size_t frontier = 0;  ///< states that they stand for
  std::size_t states = 0;    ///< in which rules and frontier were compared
  std::size_t refused = 0;   ///< pairs of a state and an event that both refuse
  /// Each a sentence: what the rules and the frontier do not agree about; that there are too many states.
  std::vector<std::string> faults;
};

/// Of each part with a supervisor, compared with its frontier in all states that are reached. A part with
/// another policy has no rules, and nothing is compared. Precondition: verifyParts() finds nothing wrong.
[[nodiscard]] std::vector<PartRules> rulesOfParts(const CellModel& model,
                                                  const std::vector<PartSupervisor>& parts,
                                                  std::size_t max_states);

}  // namespace cobot_command::cell
