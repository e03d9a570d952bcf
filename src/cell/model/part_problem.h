// The problem of one part of a cell, with or without the events that nobody else sees.
#pragma once

#include <optional>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/decomposition.h"
#include "cobot_command/automata/verification.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/model/supervisors.h"

namespace cobot_command::cell {

/// Without automata, where the supervisor is of no part of the cell.
[[nodiscard]] automata::PartOfProblem partOf(const CellModel& model, const PartSupervisor& supervisor);

class PartProblem {
 public:
  PartProblem(const CellModel& model, const automata::PartOfProblem& part, bool is_compressed);

  [[nodiscard]] const automata::Problem& problem() const { return problem_; }
  /// Nothing: it is left out, or of another part.
  [[nodiscard]] std::optional<automata::EventIndex> eventOf(automata::EventIndex of_cell) const {
    return events_[of_cell];
  }
  /// From a state of the whole cell.
  [[nodiscard]] automata::Tuple tupleOf(const automata::Tuple& of_cell) const;
  /// All that became this state of an automaton of the part, as states in the cell; ascending.
  [[nodiscard]] std::vector<automata::StateIndex> statesOfCell(std::size_t automaton,
                                                               automata::StateIndex state) const;
  [[nodiscard]] automata::Holds holds(const CellModel& model) const;

 private:
  automata::Problem problem_;
  std::vector<std::size_t> automata_;                        ///< of the cell
  std::vector<std::optional<automata::EventIndex>> events_;  ///< by event of the cell
  std::vector<std::vector<automata::StateIndex>> state_of_;  ///< by automaton, and by its state in the cell
};

}  // namespace cobot_command::cell
