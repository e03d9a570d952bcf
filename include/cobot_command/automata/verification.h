// Whether a supervisor is what it should be, found out anew from what an artifact holds (cell.md, M23).
//
// Shares no code with the synthesis: neither composition, nor state space, nor the search for the largest
// solution.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/automata/supervisor.h"

namespace cobot_command::automata {

/// What a robot holds, by automaton of the problem and local state: numbers of zones, ascending. Empty for
/// what holds nothing, such as specs.
using Holds = std::vector<std::vector<std::vector<std::size_t>>>;

struct VerificationLimits {
  std::size_t max_states = 5000000;
};

struct VerificationCounts {
  std::size_t plant_and_spec = 0;
  std::size_t dead = 0;      ///< of those: not marked, and nothing is possible
  std::size_t blocking = 0;  ///< from which no marked state can be reached
  std::size_t states = 0;    ///< reached under the supervisor
  std::size_t transitions = 0;
  std::size_t refused_by_spec = 0;
  std::size_t refused_beyond_spec = 0;
};

struct Verification {
  /// Each a sentence with the events that lead there; empty: it is proved to be mutually exclusive,
  /// controllable, non-blocking and maximally permissive, and to be the one with that fingerprint; and, where
  /// it is known what robots hold, not to be left by a booking that is taken back.
  std::vector<std::string> faults;
  VerificationCounts counts;
};

/// `fingerprint`: of the supervisor that was synthesized; of any, when it is empty. `holds` may be empty
/// where nothing is known of zones.
[[nodiscard]] Verification verify(const CompiledSupervisor& supervisor, const std::string& fingerprint,
                                  const Holds& holds = {}, VerificationLimits limits = {});

}  // namespace cobot_command::automata
