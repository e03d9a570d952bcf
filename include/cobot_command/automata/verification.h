// Verifies a supervisor from the contents of an artifact (doc/cell.md).
//
// Shares no code with the synthesis: neither composition, nor state space, nor the search for the largest
// solution.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/automata/supervisor.h"

namespace cobot_command::automata {

/// The zones that a robot holds, [automaton of the problem][local state]: zone numbers, ascending. Empty for
/// automata that hold nothing, such as specs.
using Holds = std::vector<std::vector<std::vector<std::size_t>>>;

struct VerificationLimits {
  std::size_t max_states = 5000000;
};

struct VerificationCounts {
  std::size_t plant_and_spec = 0;
  std::size_t dead = 0;      ///< of these: not marked, and no event is possible
  std::size_t blocking = 0;  ///< of these: no marked state is reachable
  std::size_t states = 0;    ///< reached under the supervisor
  std::size_t transitions = 0;
  std::size_t refused_by_spec = 0;
  std::size_t refused_beyond_spec = 0;
};

struct Verification {
  /// One sentence per fault, with the events that lead there. Empty: the supervisor is proven to be mutually
  /// exclusive, controllable, non-blocking and maximally permissive, and to have that fingerprint. If the
  /// zones of the robots are given, it is also proven that taking back a booking never leaves it.
  std::vector<std::string> faults;
  VerificationCounts counts;
};

/// `fingerprint`: of the synthesized supervisor; empty: of any. `holds` may be empty if the zones are
/// unknown.
[[nodiscard]] Verification verify(const CompiledSupervisor& supervisor, const std::string& fingerprint,
                                  const Holds& holds = {}, VerificationLimits limits = {});

}  // namespace cobot_command::automata
