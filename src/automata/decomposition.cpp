#include "cobot_command/automata/decomposition.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cobot_command::automata {
namespace {

constexpr EventIndex kNoEvent = ~EventIndex{0};

/// Sets that grow together, each known by its lowest member.
class Groups {
 public:
  explicit Groups(std::size_t size) : leader_(size) {
    std::iota(leader_.begin(), leader_.end(), std::size_t{0});
  }

  std::size_t leaderOf(std::size_t member) {
    while (leader_[member] != member) member = leader_[member] = leader_[leader_[member]];
    return member;
  }
  void unite(std::size_t one, std::size_t other) {
    one = leaderOf(one);
    other = leaderOf(other);
    leader_[std::max(one, other)] = std::min(one, other);
  }

 private:
  std::vector<std::size_t> leader_;
};

Groups groupsOf(const Problem& problem) {
  Groups groups(problem.automata.size());
  std::vector<std::size_t> first_user(problem.events.size(), problem.automata.size());
  for (std::size_t automaton = 0; automaton < problem.automata.size(); ++automaton) {
    for (const EventIndex event : problem.automata[automaton].alphabet) {
      if (first_user[event] == problem.automata.size()) first_user[event] = automaton;
      groups.unite(first_user[event], automaton);
    }
  }
  return groups;
}

void add(PartOfProblem& part, const Problem& problem, std::size_t index, std::vector<EventIndex>& new_event) {
  Automaton automaton = problem.automata[index];
  for (EventIndex& event : automaton.alphabet) {
    if (new_event[event] == kNoEvent) {
      new_event[event] = static_cast<EventIndex>(part.events.size());
      part.events.push_back(event);
      part.problem.events.push_back(problem.events[event]);
    }
    event = new_event[event];
  }
  for (Transition& transition : automaton.transitions) transition.event = new_event[transition.event];
  part.automata.push_back(index);
  part.problem.automata.push_back(std::move(automaton));
}

}  // namespace

std::vector<PartOfProblem> independentParts(const Problem& problem) {
  Groups groups = groupsOf(problem);
  std::vector<PartOfProblem> parts;
  std::vector<EventIndex> new_event(problem.events.size(), kNoEvent);
  for (std::size_t leader = 0; leader < problem.automata.size(); ++leader) {
    if (groups.leaderOf(leader) != leader) continue;
    PartOfProblem& part = parts.emplace_back();
    part.problem.name = problem.name;
    part.problem.about = problem.about;
    for (std::size_t automaton = leader; automaton < problem.automata.size(); ++automaton) {
      if (groups.leaderOf(automaton) == leader) add(part, problem, automaton, new_event);
    }
  }
  return parts;
}

}  // namespace cobot_command::automata
