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
  SafeOrder,        ///< nearly as permissive, decided without a table of states
  MutualExclusion,  ///< zones only: may deadlock. Shows why more is needed
  None              ///< ignores zones. For simulations that must fail
};
[[nodiscard]] const char* toString(Policy policy);
[[nodiscard]] std::optional<Policy> policyNamed(std::string_view name);
inline constexpr const char* kPoliciesAllowed = "supervisor, safe_order, mutex, none";

/// The supervisor of one part, in the form that is stored.
struct PartSupervisor {
  std::vector<std::size_t> automata;  ///< of the problem, ascending
  Policy policy = Policy::Supervisor;
  /// The frontier belongs to the model without events that only one robot sees, because the complete model
  /// has too many states.
  bool is_compressed = false;
  std::vector<automata::Tuple> frontier;  ///< ascending
  std::string fingerprint;                ///< of a Supervisor
  automata::SynthesisCounts counts;
  std::vector<std::string> never;  ///< names of program events that a Supervisor never permits
};

/// With Policy::Supervisor, a part with more than `max_states` states is compressed, and a part that is still
/// too large uses safe orders. A fault is a sentence: an unavoidable conflict, and the events that lead to
/// it.
[[nodiscard]] Result<std::vector<PartSupervisor>, std::string> synthesizeParts(const CellModel& model,
                                                                               Policy policy,
                                                                               std::size_t max_states);

/// Verifies each part with Policy::Supervisor, by code that shares nothing with the synthesis. For safe
/// orders it checks that they are applicable.
[[nodiscard]] std::vector<automata::Verification> verifyParts(const CellModel& model,
                                                              const std::vector<PartSupervisor>& parts,
                                                              std::size_t max_states);

}  // namespace cobot_command::cell
