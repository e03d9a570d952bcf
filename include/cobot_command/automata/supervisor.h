// What decides while the plants run: their automata, and the states that are kept out of (cell.md, M22).
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

/// A supervisor as data: what an artifact holds.
struct CompiledSupervisor {
  Problem problem;
  std::vector<Tuple> frontier;  ///< in ascending order; a controllable event must not lead to any
};
/// Precondition: the synthesis is of that problem and not empty.
[[nodiscard]] CompiledSupervisor compile(const Synthesis& synthesis, const Problem& problem);

struct Decision {
  enum class Verdict {
    Granted,
    UnknownEvent,
    NotInPlants,  ///< no plant could make it here
    SpecBlocks,
    WouldBlock,  ///< it would lead to where not all come home any more
    BreaksSpec   ///< an uncontrollable one that a spec blocks, or that leads to where it must not: the model
                 ///< is wrong
  };
  Verdict verdict = Verdict::UnknownEvent;
  std::optional<std::size_t> automaton;  ///< that cannot make it, if one cannot
  Tuple next;                            ///< where it leads, if nobody but the supervisor speaks against it
};

class Supervisor {
 public:
  /// Precondition: faultsOf(problem) is empty, and each tuple of the frontier has a state of each automaton.
  explicit Supervisor(CompiledSupervisor compiled);

  /// Precondition: `state` is one that granted events have led to.
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
