#include "cobot_command/automata/problem.h"

#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::automata {
namespace {

class Checker {
 public:
  explicit Checker(const Problem& problem) : problem_(problem) {}

  std::vector<std::string> faults() {
    findDoubledNames();
    for (const Automaton& automaton : problem_.automata) check(automaton);
    if (faults_.empty()) findEventsOfNoPlant();
    return std::move(faults_);
  }

 private:
  void findDoubledNames() {
    std::set<std::string> events;
    for (const Event& event : problem_.events) {
      if (event.name.empty()) faults_.emplace_back("an event has no name: give it one");
      if (!events.insert(event.name).second) {
        fault("the event \"{}\" appears twice: names must be unique", event.name);
      }
    }
    std::set<std::string> names;
    for (const Automaton& automaton : problem_.automata) {
      if (!names.insert(automaton.name).second) {
        fault("the automaton \"{}\" appears twice: names must be unique", automaton.name);
      }
    }
    if (problem_.automata.empty()) {
      faults_.emplace_back("there is no automaton: at least one plant is needed");
    }
  }

  void check(const Automaton& automaton) {
    if (automaton.states.empty()) return fault("{}: it has no states", automaton.name);
    std::set<std::string> states;
    for (const std::string& state : automaton.states) {
      if (!states.insert(state).second) fault("{}: the state \"{}\" appears twice", automaton.name, state);
    }
    if (automaton.initial >= automaton.states.size()) {
      fault("{}: its initial state is not one of its states", automaton.name);
    }
    if (automaton.marked.empty()) {
      fault("{}: no state is marked, so it can never complete a task: mark one", automaton.name);
    }
    for (const StateIndex state : automaton.marked) {
      if (state >= automaton.states.size()) {
        fault("{}: a marked state is not one of its states", automaton.name);
      }
    }
    std::set<EventIndex> alphabet;
    for (const EventIndex event : automaton.alphabet) {
      if (event >= problem_.events.size()) {
        fault("{}: its alphabet has an event that the problem does not have", automaton.name);
      } else if (!alphabet.insert(event).second) {
        fault("{}: its alphabet has \"{}\" twice", automaton.name, problem_.events[event].name);
      }
    }
    checkTransitions(automaton, alphabet);
  }

  void checkTransitions(const Automaton& automaton, const std::set<EventIndex>& alphabet) {
    std::map<std::pair<StateIndex, EventIndex>, StateIndex> known;
    for (const Transition& transition : automaton.transitions) {
      if (transition.from >= automaton.states.size() || transition.to >= automaton.states.size()) {
        fault("{}: a transition starts or ends in a state that is not one of its states", automaton.name);
        continue;
      }
      if (alphabet.count(transition.event) == 0) {
        fault("{}: a transition from \"{}\" has an event that is not in its alphabet", automaton.name,
              automaton.states[transition.from]);
        continue;
      }
      const auto [at, is_new] = known.try_emplace({transition.from, transition.event}, transition.to);
      if (!is_new) {
        fault("{}: \"{}\" leads from \"{}\" to \"{}\" and to \"{}\": an event leads to one state only",
              automaton.name, problem_.events[transition.event].name, automaton.states[transition.from],
              automaton.states[at->second], automaton.states[transition.to]);
      }
    }
  }

  void findEventsOfNoPlant() {
    std::vector<bool> has_plant(problem_.events.size());
    for (const Automaton& automaton : problem_.automata) {
      if (automaton.kind != Automaton::Kind::Plant) continue;
      for (const EventIndex event : automaton.alphabet) has_plant[event] = true;
    }
    for (EventIndex event = 0; event < has_plant.size(); ++event) {
      if (!has_plant[event]) {
        fault("no plant has the event \"{}\", so it can never happen", problem_.events[event].name);
      }
    }
  }

  template <class... Values>
  void fault(fmt::format_string<Values...> text, Values&&... values) {
    faults_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  const Problem& problem_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faultsOf(const Problem& problem) {
  return Checker(problem).faults();
}

}  // namespace cobot_command::automata
