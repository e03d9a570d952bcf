// The supervisors of a cell: one for each part whose robots share zones, directly or through others.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/synthesis.h"
#include "cobot_command/automata/verification.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/common/result.h"

namespace cobot_command::cell {

enum class Policy {
  Supervisor,       ///< the largest behaviour that never blocks
  SafeOrder,        ///< nearly that, decided without a table of states
  MutualExclusion,  ///< zones alone: may block for ever. To see why more is needed
  None              ///< not even zones. For simulations that have to fail
};
[[nodiscard]] const char* toString(Policy policy);
[[nodiscard]] std::optional<Policy> policyNamed(std::string_view name);
inline constexpr const char* kPoliciesAllowed = "supervisor, safe_order, mutex, none";

/// Of one part: as it was found, to be written down.
struct PartSupervisor {
  std::vector<std::size_t> automata;  ///< of the problem, ascending
  Policy policy = Policy::Supervisor;
  /// The frontier is of the model without the events that nobody else sees: the whole one has too many
  /// states.
  bool is_compressed = false;
  std::vector<automata::Tuple> frontier;  ///< ascending
  std::string fingerprint;                ///< of a Supervisor
  automata::SynthesisCounts counts;
  std::vector<std::string> never;  ///< names of events that programs have, and a Supervisor never lets happen
};

/// With Policy::Supervisor, a part whose states are more than `max_states` is compressed, and one that is too
/// large even then has safe orders. A fault is a sentence: nothing can be done about a conflict that cannot
/// be refused, and the way into it.
[[nodiscard]] Result<std::vector<PartSupervisor>, std::string> synthesizeParts(const CellModel& model,
                                                                               Policy policy,
                                                                               std::size_t max_states);

/// Verifies each of Policy::Supervisor, by code that shares nothing with the synthesis; of safe orders, that
/// they may be used.
[[nodiscard]] std::vector<automata::Verification> verifyParts(const CellModel& model,
                                                              const std::vector<PartSupervisor>& parts,
                                                              std::size_t max_states);

}  // namespace cobot_command::cell
