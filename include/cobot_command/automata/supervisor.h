// The supervisor at run time: the automata, and the states that it must avoid (doc/cell.md).
//
// A state is the tuple of the automata; there is no table of all states. Immutable; safe to share between
// threads.
#pragma once

#include <optional>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/packed_states.h"
#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/synthesis.h"

namespace cobot_command::automata {

/// A supervisor as data, as stored in an artifact.
struct CompiledSupervisor {
  Problem problem;
  std::vector<Tuple> frontier;  ///< ascending; a controllable event must not lead to any of these states
};
/// Precondition: the synthesis belongs to that problem and is not empty.
[[nodiscard]] CompiledSupervisor compile(const Synthesis& synthesis, const Problem& problem);

struct Decision {
  enum class Verdict {
    Granted,
    UnknownEvent,
    NotInPlants,  ///< no plant has a transition for it in this state
    SpecBlocks,
    WouldBlock,  ///< it would lead to a state from which not all can reach home
    BreaksSpec  ///< an uncontrollable event that a spec blocks, or that leads to a forbidden state: the model
                ///< is wrong
  };
  Verdict verdict = Verdict::UnknownEvent;
  std::optional<std::size_t> automaton;  ///< without a transition for it, if there is one
  Tuple next;  ///< the next state, if only the supervisor refuses the event or nothing does
};

class Supervisor {
 public:
  /// Precondition: faultsOf(problem) is empty, and each tuple of the frontier has one valid state per
  /// automaton.
  explicit Supervisor(CompiledSupervisor compiled);

  /// Precondition: `state` was reached by granted events.
  [[nodiscard]] Decision decide(const Tuple& state, EventIndex event) const;
  [[nodiscard]] const Tuple& initial() const { return composition_.initial(); }
  [[nodiscard]] bool isMarked(const Tuple& state) const { return composition_.isMarked(state.data()); }
  [[nodiscard]] const CompiledSupervisor& compiled() const { return compiled_; }

 private:
  CompiledSupervisor compiled_;
  Composition composition_;
  PackedStates frontier_;
};

}  // namespace cobot_command::automata
