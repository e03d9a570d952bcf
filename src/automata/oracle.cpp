#include "cobot_command/automata/oracle.h"

#include <algorithm>
#include <deque>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/automata/canonical.h"
#include "cobot_command/automata/formats.h"
#include "cobot_command/automata/safe_order.h"
#include "cobot_command/automata/state_space.h"
#include "cobot_command/automata/synthesis.h"
#include "cobot_command/automata/undo.h"

namespace cobot_command::automata {
namespace {

using nlohmann::json;
using Number = StateSpace::Number;

/// More than any problem of the file has.
constexpr std::size_t kMaxStates = 1000000;

json plantFigures(const Problem& problem) {
  const Composition plants(problem, Composition::Part::Plants);
  const auto space = StateSpace::explore(plants, kMaxStates);
  if (!space) return {};
  return {{"states", space->size()}, {"transitions", space->edgeCount()}};
}

json spaceFigures(const StateSpace& space) {
  const Troubles troubles = troublesOf(space);
  return {{"states", space.size()},        {"transitions", space.edgeCount()},
          {"marked", troubles.marked},     {"deadlocks", troubles.deadlocks},
          {"blocking", troubles.blocking}, {"uncontrollable_states", troubles.breaking_spec}};
}

json supervisorFigures(const Synthesis& synthesis, const Problem& problem) {
  const SynthesisCounts& counts = synthesis.counts();
  json figures = {{"states", counts.states},
                  {"transitions", counts.transitions},
                  {"marked", counts.marked},
                  {"empty", synthesis.empty()},
                  {"disabled_by_spec", counts.refused_by_spec},
                  {"disabled_beyond_spec", counts.refused_beyond_spec},
                  {"frontier_states", counts.frontier},
                  {"fingerprint", nullptr}};
  if (synthesis.empty()) return figures;
  const CanonicalForm form = canonicalFormOf(automatonOf(synthesis, problem), problem.events);
  figures["fingerprint"] = form.fingerprint(problem.events);
  figures["marked_states"] = form.marked;
  figures["listing"] = json::array();
  for (const Transition& transition : form.transitions) {
    figures["listing"].push_back({transition.from, problem.events[transition.event].name, transition.to});
  }
  return figures;
}

/// What a rule would leave that refuses only what leads into a dead state at once: the supervisor must not be
/// that.
json shallowFigures(const StateSpace& space) {
  const auto is_dead = [&](Number state) { return space.edges(state).empty() && !space.isMarked(state); };
  std::vector<bool> reached(space.size(), false);
  std::vector<Number> open = {0};
  reached[0] = true;
  std::size_t states = 0;
  std::size_t deadlocks = 0;
  while (!open.empty()) {
    const Number state = open.back();
    open.pop_back();
    ++states;
    bool goes_on = false;
    for (const auto& edge : space.edges(state)) {
      if (is_dead(edge.to)) continue;
      goes_on = true;
      if (reached[edge.to]) continue;
      reached[edge.to] = true;
      open.push_back(edge.to);
    }
    if (!goes_on && !space.isMarked(state)) ++deadlocks;
  }
  return {{"states", states}, {"deadlocks", deadlocks}};
}

json safeOrderFigures(const Problem& problem, SafeOrder::Claim claim) {
  const SafeOrder rule(problem, claim);
  std::set<Tuple> reached = {rule.initial()};
  std::deque<Tuple> open = {rule.initial()};
  std::size_t transitions = 0;
  while (!open.empty()) {
    const Tuple state = std::move(open.front());
    open.pop_front();
    for (EventIndex event = 0; event < problem.events.size(); ++event) {
      const Decision decision = rule.decide(state, event);
      if (decision.verdict != Decision::Verdict::Granted) continue;
      ++transitions;
      if (reached.insert(decision.next).second) open.push_back(decision.next);
    }
  }
  return {{"states", reached.size()}, {"transitions", transitions}};
}

json figuresOf(const Problem& problem) {
  const Composition composition(problem);
  const auto space = StateSpace::explore(composition, kMaxStates);
  if (!space) return {};
  const Synthesis synthesis(*space);
  const UndoCounts undo = countUndoes(synthesis, problem);
  json figures = {{"plant", plantFigures(problem)},
                  {"plant_and_spec", spaceFigures(*space)},
                  {"supervisor", supervisorFigures(synthesis, problem)},
                  {"one_step_lookahead", shallowFigures(*space)},
                  {"undo", {{"bookings", undo.bookings}, {"outside", undo.outside}}}};
  if (SafeOrder::objectionsTo(problem).empty()) {
    figures["safe_order"] = {{"step_by_step", safeOrderFigures(problem, SafeOrder::Claim::StepByStep)},
                             {"whole_cycle", safeOrderFigures(problem, SafeOrder::Claim::WholeCycle)}};
  }
  return figures;
}

void compare(const json& expected, const json& found, const std::string& path, const std::string& problem,
             std::vector<OracleFigure>& figures) {
  for (const auto& [key, value] : expected.items()) {
    if (key == "schedule") continue;
    const std::string place = path.empty() ? key : fmt::format("{}.{}", path, key);
    const json& ours = found.is_object() && found.contains(key) ? found[key] : json();
    if (value.is_object()) {
      compare(value, ours, place, problem, figures);
    } else if (value.is_array()) {
      figures.push_back({problem, place, fmt::format("{} entries", value.size()),
                         value == ours ? fmt::format("{} entries", value.size()) : "others"});
    } else {
      figures.push_back({problem, place, value.is_string() ? value.get<std::string>() : value.dump(),
                         ours.is_string() ? ours.get<std::string>() : ours.dump()});
    }
  }
}

}  // namespace

Result<std::vector<OracleFigure>, std::string> compareWithOracles(std::string_view file) {
  const auto problems = problemsFromJson(file);
  if (!problems) return refuse(problems.error());
  const json source = json::parse(file, nullptr, false);
  std::vector<OracleFigure> figures;
  for (std::size_t index = 0; index < problems->size(); ++index) {
    const json& entry = source["problems"][index];
    if (!entry.contains("expected")) continue;
    compare(entry["expected"], figuresOf((*problems)[index]), "", (*problems)[index].name, figures);
  }
  return figures;
}

}  // namespace cobot_command::automata
