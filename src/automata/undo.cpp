#include "cobot_command/automata/undo.h"

namespace cobot_command::automata {
namespace {

constexpr StateIndex kNone = ~StateIndex{0};
constexpr StateIndex kSeveral = kNone - 1;

}  // namespace

Undo::Undo(const Problem& problem)
    : participants_(problem.events.size()), is_booking_(problem.events.size(), false) {
  for (std::size_t index = 0; index < problem.automata.size(); ++index) {
    const Automaton& automaton = problem.automata[index];
    for (const EventIndex event : automaton.alphabet) {
      participants_[event].push_back({index, std::vector<StateIndex>(automaton.states.size(), kNone)});
      if (automaton.kind == Automaton::Kind::Spec && problem.events[event].controllable) {
        is_booking_[event] = true;
      }
    }
    for (const Transition& transition : automaton.transitions) {
      StateIndex& previous = participants_[transition.event].back().previous[transition.to];
      previous = previous == kNone ? transition.from : kSeveral;
    }
  }
}

std::optional<Tuple> Undo::before(const Tuple& tuple, EventIndex event) const {
  Tuple before = tuple;
  for (const Participant& participant : participants_[event]) {
    const StateIndex previous = participant.previous[tuple[participant.automaton]];
    if (previous == kNone || previous == kSeveral) return std::nullopt;
    before[participant.automaton] = previous;
  }
  return before;
}

UndoCounts countUndoes(const Synthesis& synthesis, const Problem& problem) {
  const Undo undo(problem);
  const PackedStates& states = synthesis.space().states();
  UndoCounts counts;
  for (StateSpace::Number state = 0; state < states.size(); ++state) {
    if (!synthesis.contains(state)) continue;
    const Tuple tuple = states.tuple(state);
    for (EventIndex event = 0; event < problem.events.size(); ++event) {
      if (!undo.isBooking(event)) continue;
      const auto before = undo.before(tuple, event);
      if (!before) continue;
      ++counts.bookings;
      const auto number = states.find(before->data());
      if (!number || !synthesis.contains(*number)) ++counts.outside;
    }
  }
  return counts;
}

}  // namespace cobot_command::automata
