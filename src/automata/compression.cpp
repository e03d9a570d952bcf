#include "cobot_command/automata/compression.h"

#include <algorithm>

namespace cobot_command::automata {
namespace {

constexpr StateIndex kNone = ~StateIndex{0};

/// By event: whether it is left out.
std::vector<bool> leftOut(const Problem& problem, const std::vector<EventIndex>& kept) {
  std::vector<std::size_t> users(problem.events.size(), 0);
  std::vector<bool> left_out(problem.events.size(), true);
  for (const Automaton& automaton : problem.automata) {
    for (const EventIndex event : automaton.alphabet) {
      ++users[event];
      if (automaton.kind != Automaton::Kind::Plant) left_out[event] = false;
    }
    std::vector<std::size_t> ways(automaton.states.size(), 0);
    for (const Transition& transition : automaton.transitions) ++ways[transition.from];
    for (const Transition& transition : automaton.transitions) {
      if (ways[transition.from] != 1) left_out[transition.event] = false;
    }
  }
  for (EventIndex event = 0; event < users.size(); ++event) {
    if (users[event] != 1) left_out[event] = false;
  }
  for (const EventIndex event : kept) left_out[event] = false;
  return left_out;
}

/// By old local state: where the events that are left out lead to by themselves; in a circle of them, its
/// lowest state.
std::vector<StateIndex> endsOf(const Automaton& automaton, const std::vector<bool>& left_out) {
  std::vector<StateIndex> next(automaton.states.size(), kNone);
  for (const Transition& transition : automaton.transitions) {
    if (left_out[transition.event]) next[transition.from] = transition.to;
  }
  std::vector<StateIndex> ends(automaton.states.size());
  for (StateIndex state = 0; state < ends.size(); ++state) {
    StateIndex end = state;
    for (std::size_t steps = 0; next[end] != kNone && steps < ends.size(); ++steps) end = next[end];
    if (next[end] != kNone) {
      StateIndex lowest = end;
      for (StateIndex at = next[end]; at != end; at = next[at]) lowest = std::min(lowest, at);
      end = lowest;
    }
    ends[state] = end;
  }
  return ends;
}

/// The new index of each old event, where it is not left out.
std::vector<EventIndex> newEvents(const std::vector<bool>& left_out) {
  std::vector<EventIndex> index(left_out.size(), kNone);
  EventIndex next = 0;
  for (EventIndex event = 0; event < left_out.size(); ++event) {
    if (!left_out[event]) index[event] = next++;
  }
  return index;
}

/// The states that stay, and the new index of each old one.
std::vector<StateIndex> addStates(const Automaton& automaton, const std::vector<StateIndex>& ends,
                                  Automaton& smaller) {
  std::vector<StateIndex> index(automaton.states.size(), kNone);
  for (StateIndex state = 0; state < ends.size(); ++state) {
    if (ends[state] != state) continue;
    index[state] = static_cast<StateIndex>(smaller.states.size());
    smaller.states.push_back(automaton.states[state]);
  }
  std::vector<StateIndex> state_of(automaton.states.size());
  for (StateIndex state = 0; state < ends.size(); ++state) state_of[state] = index[ends[state]];
  return state_of;
}

/// Returns the new index of each old state.
std::vector<StateIndex> compressInto(Automaton& smaller, const Automaton& automaton,
                                     const std::vector<bool>& left_out) {
  const std::vector<EventIndex> new_event = newEvents(left_out);
  smaller.name = automaton.name;
  smaller.kind = automaton.kind;
  std::vector<StateIndex> state_of = addStates(automaton, endsOf(automaton, left_out), smaller);
  smaller.initial = state_of[automaton.initial];
  for (const StateIndex state : automaton.marked) smaller.marked.push_back(state_of[state]);
  std::sort(smaller.marked.begin(), smaller.marked.end());
  smaller.marked.erase(std::unique(smaller.marked.begin(), smaller.marked.end()), smaller.marked.end());
  for (const EventIndex event : automaton.alphabet) {
    if (!left_out[event]) smaller.alphabet.push_back(new_event[event]);
  }
  for (const Transition& transition : automaton.transitions) {
    if (left_out[transition.event]) continue;
    smaller.transitions.push_back(
        {state_of[transition.from], new_event[transition.event], state_of[transition.to]});
  }
  return state_of;
}

}  // namespace

Compressed compress(const Problem& problem, const std::vector<EventIndex>& kept) {
  const std::vector<bool> left_out = leftOut(problem, kept);
  Compressed compressed;
  compressed.problem.name = problem.name;
  compressed.problem.about = problem.about;
  for (EventIndex event = 0; event < problem.events.size(); ++event) {
    if (left_out[event]) continue;
    compressed.events.push_back(event);
    compressed.problem.events.push_back(problem.events[event]);
  }
  for (const Automaton& automaton : problem.automata) {
    Automaton& smaller = compressed.problem.automata.emplace_back();
    compressed.state_of.push_back(compressInto(smaller, automaton, left_out));
  }
  return compressed;
}

}  // namespace cobot_command::automata
