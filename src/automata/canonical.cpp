#include "cobot_command/automata/canonical.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "cobot_command/common/sha256.h"

namespace cobot_command::automata {
namespace {

constexpr StateIndex kUnnumbered = ~StateIndex{0};

/// The place of each event in byte order of the names.
std::vector<std::size_t> ranksOf(const std::vector<Event>& events) {
  std::vector<EventIndex> order(events.size());
  std::iota(order.begin(), order.end(), EventIndex{0});
  std::sort(order.begin(), order.end(),
            [&](auto one, auto other) { return events[one].name < events[other].name; });
  std::vector<std::size_t> ranks(events.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) ranks[order[rank]] = rank;
  return ranks;
}

/// Sorted by where they begin, and there by the names of their events.
std::vector<Transition> sorted(std::vector<Transition> transitions, const std::vector<Event>& events) {
  const auto ranks = ranksOf(events);
  std::sort(transitions.begin(), transitions.end(), [&](const Transition& one, const Transition& other) {
    return one.from != other.from ? one.from < other.from : ranks[one.event] < ranks[other.event];
  });
  return transitions;
}

std::string nameOf(const Tuple& tuple, const Problem& problem) {
  std::string name;
  for (std::size_t automaton = 0; automaton < tuple.size(); ++automaton) {
    if (automaton != 0) name += '|';
    name += problem.automata[automaton].states[tuple[automaton]];
  }
  return name;
}

}  // namespace

CanonicalForm canonicalFormOf(const Automaton& automaton, const std::vector<Event>& events) {
  const std::vector<Transition> transitions = sorted(automaton.transitions, events);
  std::vector<StateIndex> number(automaton.states.size(), kUnnumbered);
  std::vector<StateIndex> order = {automaton.initial};
  number[automaton.initial] = 0;
  CanonicalForm form;
  for (std::size_t at = 0; at < order.size(); ++at) {
    const auto begin =
        std::lower_bound(transitions.begin(), transitions.end(), order[at],
                         [](const Transition& one, StateIndex state) { return one.from < state; });
    for (auto one = begin; one != transitions.end() && one->from == order[at]; ++one) {
      if (number[one->to] == kUnnumbered) {
        number[one->to] = static_cast<StateIndex>(order.size());
        order.push_back(one->to);
      }
      form.transitions.push_back({static_cast<StateIndex>(at), one->event, number[one->to]});
    }
  }
  for (const StateIndex state : automaton.marked) {
    if (number[state] != kUnnumbered) form.marked.push_back(number[state]);
  }
  std::sort(form.marked.begin(), form.marked.end());
  form.states = order.size();
  return form;
}

std::string CanonicalForm::fingerprint(const std::vector<Event>& events) const {
  Sha256 hash;
  for (const Transition& transition : transitions) {
    hash.update(fmt::format("{} {} {}\n", transition.from, events[transition.event].name, transition.to));
  }
  hash.update("marked");
  for (const StateIndex state : marked) hash.update(fmt::format(" {}", state));
  hash.update("\n");
  return hash.hex();
}

Automaton automatonOf(const Synthesis& synthesis, const Problem& problem) {
  const StateSpace& space = synthesis.space();
  Automaton automaton;
  automaton.name = "supervisor";
  automaton.kind = Automaton::Kind::Spec;
  for (EventIndex event = 0; event < problem.events.size(); ++event) automaton.alphabet.push_back(event);
  std::vector<StateIndex> index(space.size(), kUnnumbered);
  for (StateSpace::Number state = 0; state < space.size(); ++state) {
    if (!synthesis.contains(state)) continue;
    index[state] = static_cast<StateIndex>(automaton.states.size());
    automaton.states.push_back(nameOf(space.states().tuple(state), problem));
    if (space.isMarked(state)) automaton.marked.push_back(index[state]);
  }
  for (StateSpace::Number state = 0; state < space.size(); ++state) {
    if (!synthesis.contains(state)) continue;
    for (const auto& edge : space.edges(state)) {
      if (synthesis.contains(edge.to)) {
        automaton.transitions.push_back({index[state], edge.event, index[edge.to]});
      }
    }
  }
  return automaton;
}

}  // namespace cobot_command::automata
