#include "verification_model.h"

#include <algorithm>
#include <numeric>

namespace cobot_command::automata::verification {
namespace {

std::string bytesOf(const Tuple& tuple) {
  return {reinterpret_cast<const char*>(tuple.data()), tuple.size() * sizeof(StateIndex)};
}

}  // namespace

Model::Model(const Problem& problem)
    : problem_(problem),
      by_name_(problem.events.size()),
      users_(problem.events.size()),
      next_(problem.automata.size()),
      previous_(problem.automata.size()) {
  std::iota(by_name_.begin(), by_name_.end(), EventIndex{0});
  std::sort(by_name_.begin(), by_name_.end(), [&](EventIndex one, EventIndex other) {
    return problem.events[one].name < problem.events[other].name;
  });
  for (std::size_t index = 0; index < problem.automata.size(); ++index) {
    for (const EventIndex event : problem.automata[index].alphabet) users_[event].push_back(index);
    for (const Transition& transition : problem.automata[index].transitions) {
      next_[index][{transition.from, transition.event}] = transition.to;
      const auto [at, is_new] =
          previous_[index].try_emplace({transition.to, transition.event}, transition.from);
      if (!is_new) at->second.reset();
    }
  }
}

bool Model::explore(std::size_t max_states) {
  Tuple initial;
  for (const Automaton& automaton : problem_.automata) initial.push_back(automaton.initial);
  numberOf(initial);
  for (std::uint32_t number = 0; number < states_.size(); ++number) {
    if (states_.size() > max_states) return false;
    expand(number);
  }
  return true;
}

std::optional<std::uint32_t> Model::find(const Tuple& tuple) const {
  const auto at = numbers_.find(bytesOf(tuple));
  return at == numbers_.end() ? std::nullopt : std::optional(at->second);
}

std::optional<Tuple> Model::before(const Tuple& tuple, EventIndex event) const {
  Tuple before = tuple;
  for (const std::size_t index : users_[event]) {
    const auto at = previous_[index].find({tuple[index], event});
    if (at == previous_[index].end() || !at->second) return std::nullopt;
    before[index] = *at->second;
  }
  return before;
}

bool Model::isBooking(EventIndex event) const {
  return problem_.events[event].controllable &&
         std::any_of(users_[event].begin(), users_[event].end(), [this](std::size_t index) {
           return problem_.automata[index].kind == Automaton::Kind::Spec;
         });
}

std::uint32_t Model::numberOf(const Tuple& tuple) {
  const auto [at, is_new] = numbers_.try_emplace(bytesOf(tuple), static_cast<std::uint32_t>(states_.size()));
  if (is_new) {
    State state;
    state.tuple = tuple;
    state.is_marked = true;
    for (std::size_t index = 0; index < tuple.size(); ++index) {
      const auto& marked = problem_.automata[index].marked;
      if (std::find(marked.begin(), marked.end(), tuple[index]) == marked.end()) state.is_marked = false;
    }
    states_.push_back(std::move(state));
  }
  return at->second;
}

void Model::expand(std::uint32_t number) {
  const Tuple from = states_[number].tuple;
  for (const EventIndex event : by_name_) {
    Tuple to = from;
    bool plants_can = true;
    bool specs_can = true;
    for (const std::size_t index : users_[event]) {
      const auto at = next_[index].find({from[index], event});
      if (at != next_[index].end()) {
        to[index] = at->second;
      } else if (problem_.automata[index].kind == Automaton::Kind::Plant) {
        plants_can = false;
      } else {
        specs_can = false;
      }
    }
    if (!plants_can) continue;
    if (specs_can) {
      const std::uint32_t target = numberOf(to);
      states_[number].edges.push_back({event, target});
    } else if (problem_.events[event].controllable) {
      ++states_[number].refused_by_spec;
    } else {
      states_[number].breaks_spec = true;
    }
  }
}

}  // namespace cobot_command::automata::verification
