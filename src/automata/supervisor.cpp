#include "cobot_command/automata/supervisor.h"

#include <algorithm>
#include <utility>

namespace cobot_command::automata {

CompiledSupervisor compile(const Synthesis& synthesis, const Problem& problem) {
  CompiledSupervisor compiled{problem, {}};
  for (const auto state : synthesis.frontier()) {
    compiled.frontier.push_back(synthesis.space().states().tuple(state));
  }
  std::sort(compiled.frontier.begin(), compiled.frontier.end());
  return compiled;
}

Supervisor::Supervisor(CompiledSupervisor compiled)
    : compiled_(std::move(compiled)), composition_(compiled_.problem), frontier_(composition_) {
  for (const Tuple& tuple : compiled_.frontier) frontier_.insert(tuple.data());
}

Decision Supervisor::decide(const Tuple& state, EventIndex event) const {
  using Verdict = Decision::Verdict;
  if (event >= composition_.events()) return {};
  Decision decision;
  decision.next.resize(state.size());
  const bool is_controllable = composition_.isControllable(event);
  switch (composition_.step(state.data(), event, decision.next.data())) {
    case Composition::Step::NotInPlants:
      return {Verdict::NotInPlants, composition_.blockerOf(state.data(), event), {}};
    case Composition::Step::BlockedBySpec:
      return {is_controllable ? Verdict::SpecBlocks : Verdict::BreaksSpec,
              composition_.blockerOf(state.data(), event),
              {}};
    case Composition::Step::Possible:
      break;
  }
  decision.verdict = Verdict::Granted;
  if (frontier_.find(decision.next.data())) {
    decision.verdict = is_controllable ? Verdict::WouldBlock : Verdict::BreaksSpec;
  }
  return decision;
}

}  // namespace cobot_command::automata
