#include "cobot_command/cell/model/part_rules.h"

#include <algorithm>
#include <map>
#include <utility>

#include "model/part_problem.h"
#include <fmt/format.h>

#include "cobot_command/automata/frontier_rules.h"

namespace cobot_command::cell {
namespace {

class Words {
 public:
  Words(const CellModel& model, const PartSupervisor& supervisor, const PartProblem& problem)
      : model_(model), supervisor_(supervisor), problem_(problem) {}

  [[nodiscard]] std::string of(const automata::FrontierRule& rule) const {
    std::vector<std::string> conditions;
    for (const automata::RuleCondition& condition : rule.conditions) conditions.push_back(of(condition));
    if (conditions.empty()) return "nothing";
    const std::string first = conditions.front();
    conditions.erase(conditions.begin());
    return conditions.empty() ? "not " + first
                              : fmt::format("not {} while {}", first, fmt::join(conditions, " and "));
  }

 private:
  [[nodiscard]] std::string of(const automata::RuleCondition& condition) const {
    const std::size_t automaton = supervisor_.automata[condition.automaton];
    std::vector<automata::StateIndex> states;
    for (const automata::StateIndex state : condition.states) {
      const auto of_cell = problem_.statesOfCell(condition.automaton, state);
      states.insert(states.end(), of_cell.begin(), of_cell.end());
    }
    std::sort(states.begin(), states.end());
    const automata::Automaton& known = model_.problem.automata[automaton];
    if (automaton < model_.robots()) {
      return fmt::format("{} with {}", known.name, holdings(automaton, states));
    }
    std::vector<std::string> names;
    names.reserve(states.size());
    for (const automata::StateIndex state : states) names.push_back(known.states[state]);
    return fmt::format("{} at {}", known.name, fmt::join(names, " or "));
  }

  /// "Z1 (W>1, W) or Z1+Z2 (W>2)": what it holds, and at which of these places.
  [[nodiscard]] std::string holdings(RobotIndex robot,
                                     const std::vector<automata::StateIndex>& states) const {
    std::map<std::vector<ZoneIndex>, std::vector<std::string>> places;
    for (const automata::StateIndex state : states) {
      const CellPlace& place = model_.places[robot][state];
      places[place.holds].push_back(place.name);
    }
    std::vector<std::string> words;
    for (const auto& [held, names] : places) {
      std::vector<std::string> zones;
      for (const ZoneIndex zone : held) zones.push_back(model_.program.zones[zone]);
      words.push_back(fmt::format("{} ({})",
                                  zones.empty() ? "nothing" : fmt::format("{}", fmt::join(zones, "+")),
                                  fmt::join(names, ", ")));
    }
    return fmt::format("{}", fmt::join(words, " or "));
  }

  const CellModel& model_;
  const PartSupervisor& supervisor_;
  const PartProblem& problem_;
};

PartRules rulesOfPart(const CellModel& model, const PartSupervisor& supervisor, std::size_t max_states) {
  PartRules found;
  for (const std::size_t automaton : supervisor.automata) {
    if (automaton < model.robots()) found.robots.push_back(model.program.robots[automaton].name);
  }
  if (supervisor.policy != Policy::Supervisor) return found;
  const PartProblem problem(model, partOf(model, supervisor), supervisor.is_compressed);
  const automata::CompiledSupervisor compiled{problem.problem(), supervisor.frontier};
  found.frontier = supervisor.frontier.size();
  const auto rules = automata::frontierRulesOf(compiled, max_states);
  if (!rules) {
    found.faults.push_back(fmt::format(
        "there are more than {} states: the rules were not determined. Raise max_states", max_states));
    return found;
  }
  const Words words(model, supervisor, problem);
  for (const automata::FrontierRule& rule : *rules) found.rules.push_back(words.of(rule));
  automata::RuleComparison comparison = automata::compareRules(compiled, *rules, max_states);
  found.states = comparison.states;
  found.refused = comparison.refused;
  found.faults = std::move(comparison.faults);
  return found;
}

}  // namespace

std::vector<PartRules> rulesOfParts(const CellModel& model, const std::vector<PartSupervisor>& parts,
                                    std::size_t max_states) {
  std::vector<PartRules> rules;
  rules.reserve(parts.size());
  for (const PartSupervisor& supervisor : parts) rules.push_back(rulesOfPart(model, supervisor, max_states));
  return rules;
}

}  // namespace cobot_command::cell
