// Readable explanation of what the supervisors of a cell forbid: rules over few robots and their places
// (doc/cell.md).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/model/supervisors.h"

namespace cobot_command::cell {

struct PartRules {
  std::vector<std::string> robots;  ///< by name; including mechanisms
  /// One each: "not RA with Z1 (W>1) while RB with Z2 (W>1)", with the places at which they hold the zone.
  /// Empty: the zones alone are sufficient.
  std::vector<std::string> rules;
  std::size_t frontier = 0;  ///< number of states that the rules represent
  std::size_t states = 0;    ///< in which rules and frontier were compared
  std::size_t refused = 0;   ///< pairs of a state and an event that both refuse
  /// One sentence each: a difference between the rules and the frontier, or too many states.
  std::vector<std::string> faults;
};

/// The rules of each part with a supervisor, compared with its frontier in all reached states. A part with
/// another policy has no rules and is not compared. Precondition: verifyParts() finds no fault.
[[nodiscard]] std::vector<PartRules> rulesOfParts(const CellModel& model,
                                                  const std::vector<PartSupervisor>& parts,
                                                  std::size_t max_states);

}  // namespace cobot_command::cell
