#include "cobot_command/automata/composition.h"

#include <algorithm>

namespace cobot_command::automata {

Composition::Composition(const Problem& problem, Part part) : participants_(problem.events.size()) {
  for (const Event& event : problem.events) controllable_.push_back(event.controllable);
  // Plants stand first in each event: what they cannot make is nothing that a spec blocks.
  for (const auto kind : {Automaton::Kind::Plant, Automaton::Kind::Spec}) {
    if (kind == Automaton::Kind::Spec && part == Part::Plants) continue;
    for (std::size_t index = 0; index < problem.automata.size(); ++index) {
      if (problem.automata[index].kind == kind) addEvents(problem.automata[index], index);
    }
  }
  for (const Automaton& automaton : problem.automata) addStates(automaton, part);
  findCandidates();
}

void Composition::addStates(const Automaton& automaton, Part part) {
  state_counts_.push_back(static_cast<StateIndex>(automaton.states.size()));
  initial_.push_back(automaton.initial);
  const bool counts = automaton.kind == Automaton::Kind::Plant || part == Part::All;
  std::vector<bool> marked(automaton.states.size(), !counts);
  for (const StateIndex state : automaton.marked) marked[state] = true;
  marked_.push_back(std::move(marked));
}

void Composition::addEvents(const Automaton& automaton, std::size_t index) {
  for (const EventIndex event : automaton.alphabet) {
    participants_[event].push_back({index, automaton.kind == Automaton::Kind::Plant,
                                    std::vector<StateIndex>(automaton.states.size(), kNone)});
  }
  for (const Transition& transition : automaton.transitions) {
    participants_[transition.event].back().next[transition.from] = transition.to;
  }
}

void Composition::findCandidates() {
  candidates_.resize(state_counts_.size());
  for (std::size_t automaton = 0; automaton < state_counts_.size(); ++automaton) {
    candidates_[automaton].resize(state_counts_[automaton]);
  }
  for (EventIndex event = 0; event < participants_.size(); ++event) {
    const Participant& first = participants_[event].front();
    for (StateIndex state = 0; state < first.next.size(); ++state) {
      if (first.next[state] != kNone) candidates_[first.automaton][state].push_back(event);
    }
  }
}

bool Composition::isMarked(const StateIndex* tuple) const {
  for (std::size_t automaton = 0; automaton < marked_.size(); ++automaton) {
    if (!marked_[automaton][tuple[automaton]]) return false;
  }
  return true;
}

Composition::Step Composition::step(const StateIndex* from, EventIndex event, StateIndex* to) const {
  const auto& participants = participants_[event];
  for (const Participant& participant : participants) {
    if (participant.next[from[participant.automaton]] == kNone) {
      return participant.is_plant ? Step::NotInPlants : Step::BlockedBySpec;
    }
  }
  if (to != from) std::copy_n(from, size(), to);
  for (const Participant& participant : participants) {
    to[participant.automaton] = participant.next[to[participant.automaton]];
  }
  return Step::Possible;
}

std::optional<std::size_t> Composition::blockerOf(const StateIndex* from, EventIndex event) const {
  for (const Participant& participant : participants_[event]) {
    if (participant.next[from[participant.automaton]] == kNone) return participant.automaton;
  }
  return std::nullopt;
}

}  // namespace cobot_command::automata
