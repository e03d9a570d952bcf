#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/automata/formats.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::automata {
namespace {

using nlohmann::json;

/// Thrown and caught inside of this file.
struct Fault {
  std::string text;
};

template <class... Values>
[[noreturn]] void fail(fmt::format_string<Values...> text, Values&&... values) {
  throw Fault{forPeople(fmt::format(text, std::forward<Values>(values)...))};
}

const json& member(const json& object, const char* key, json::value_t kind, std::string_view place) {
  if (!object.is_object()) fail("{} is not an object", place);
  const auto at = object.find(key);
  if (at == object.end()) fail("{} has no \"{}\"", place, key);
  if (at->type() != kind) fail("{}.{} is {}, not {}", place, key, at->type_name(), json(kind).type_name());
  return *at;
}

const std::string& text(const json& value, std::string_view place) {
  if (!value.is_string()) fail("{} is {}, not a text", place, value.type_name());
  return value.get_ref<const std::string&>();
}

std::string textOr(const json& object, const char* key) {
  const auto at = object.find(key);
  return at != object.end() && at->is_string() ? at->get<std::string>() : "";
}

/// Indices of names, each once.
class Names {
 public:
  Names(std::string what, std::string place) : what_(std::move(what)), place_(std::move(place)) {}
  void add(const std::string& name) {
    if (!index_.emplace(name, static_cast<std::uint32_t>(index_.size())).second) {
      fail("{}: the {} \"{}\" appears twice", place_, what_, foreignText(name, kQuoteLimit));
    }
  }
  [[nodiscard]] std::uint32_t of(const json& value, const std::string& place) const {
    const auto at = index_.find(text(value, place));
    if (at == index_.end()) {
      fail("{}: there is no {} \"{}\"", place, what_, foreignText(text(value, place), kQuoteLimit));
    }
    return at->second;
  }

 private:
  std::string what_;
  std::string place_;
  std::map<std::string, std::uint32_t> index_;
};

Automaton::Kind kindOf(const json& automaton, const std::string& place) {
  const std::string& kind = text(member(automaton, "kind", json::value_t::string, place), place);
  if (kind == "plant") return Automaton::Kind::Plant;
  if (kind == "spec") return Automaton::Kind::Spec;
  fail("{}.kind is \"{}\": allowed are plant and spec", place, foreignText(kind, kQuoteLimit));
}

Automaton readAutomaton(const json& source, const Names& events, const std::string& place) {
  Automaton automaton;
  automaton.name = text(member(source, "name", json::value_t::string, place), place);
  automaton.kind = kindOf(source, place);
  for (const json& event : member(source, "alphabet", json::value_t::array, place)) {
    automaton.alphabet.push_back(events.of(event, place + ".alphabet"));
  }
  Names states("state", place);
  for (const json& state : member(source, "states", json::value_t::array, place)) {
    automaton.states.push_back(text(state, place + ".states"));
    states.add(automaton.states.back());
  }
  automaton.initial = states.of(member(source, "initial", json::value_t::string, place), place + ".initial");
  for (const json& state : member(source, "marked", json::value_t::array, place)) {
    automaton.marked.push_back(states.of(state, place + ".marked"));
  }
  for (const json& transition : member(source, "transitions", json::value_t::array, place)) {
    const std::string at = fmt::format("{}.transitions[{}]", place, automaton.transitions.size());
    if (!transition.is_array() || transition.size() != 3) fail("{} is not [from, event, to]", at);
    automaton.transitions.push_back(
        {states.of(transition[0], at), events.of(transition[1], at), states.of(transition[2], at)});
  }
  return automaton;
}

Problem readProblem(const json& source, const std::string& place) {
  Problem problem;
  if (!source.is_object()) fail("{} is not an object", place);
  problem.name = textOr(source, "name");
  problem.about = textOr(source, "about");
  Names events("event", place);
  for (const json& event : member(source, "events", json::value_t::array, place)) {
    const std::string at = fmt::format("{}.events[{}]", place, problem.events.size());
    problem.events.push_back({text(member(event, "name", json::value_t::string, at), at),
                              member(event, "controllable", json::value_t::boolean, at).get<bool>()});
    events.add(problem.events.back().name);
  }
  for (const json& automaton : member(source, "automata", json::value_t::array, place)) {
    const std::string at = fmt::format("{}.automata[{}]", place, problem.automata.size());
    problem.automata.push_back(readAutomaton(automaton, events, at));
  }
  const auto faults = faultsOf(problem);
  if (!faults.empty()) fail("{}: {}", place, faults.front());
  return problem;
}

json written(const Automaton& automaton, const Problem& problem) {
  json result = {{"name", automaton.name},
                 {"kind", automaton.kind == Automaton::Kind::Plant ? "plant" : "spec"},
                 {"alphabet", json::array()},
                 {"states", automaton.states},
                 {"initial", automaton.states[automaton.initial]},
                 {"marked", json::array()},
                 {"transitions", json::array()}};
  for (const EventIndex event : automaton.alphabet) result["alphabet"].push_back(problem.events[event].name);
  for (const StateIndex state : automaton.marked) result["marked"].push_back(automaton.states[state]);
  for (const Transition& transition : automaton.transitions) {
    result["transitions"].push_back({automaton.states[transition.from], problem.events[transition.event].name,
                                     automaton.states[transition.to]});
  }
  return result;
}

}  // namespace

Result<std::vector<Problem>, std::string> problemsFromJson(std::string_view text) {
  const json file = json::parse(text, nullptr, false);
  if (file.is_discarded()) return refuse(std::string("this is not JSON"));
  try {
    std::vector<Problem> problems;
    for (const json& problem : member(file, "problems", json::value_t::array, "the file")) {
      problems.push_back(readProblem(problem, fmt::format("problems[{}]", problems.size())));
    }
    return problems;
  } catch (const Fault& fault) {
    return refuse(fault.text);
  }
}

std::string toJson(const std::vector<Problem>& problems) {
  json file = {{"format", "cobot-automata"}, {"version", 1}, {"problems", json::array()}};
  for (const Problem& problem : problems) {
    json events = json::array();
    for (const Event& event : problem.events) {
      events.push_back({{"name", event.name}, {"controllable", event.controllable}});
    }
    json automata = json::array();
    for (const Automaton& automaton : problem.automata) automata.push_back(written(automaton, problem));
    file["problems"].push_back({{"name", problem.name},
                                {"about", problem.about},
                                {"events", std::move(events)},
                                {"automata", std::move(automata)}});
  }
  return file.dump(1) + "\n";
}

}  // namespace cobot_command::automata
