#include "cobot_command/cell/model/supervisors.h"

#include <array>
#include <utility>

#include "model/part_problem.h"
#include <fmt/format.h>

#include "cobot_command/automata/canonical.h"
#include "cobot_command/automata/decomposition.h"
#include "cobot_command/automata/safe_order.h"

namespace cobot_command::cell {
namespace {

constexpr std::array<std::pair<Policy, const char*>, 4> kPolicyNames = {{{Policy::Supervisor, "supervisor"},
                                                                         {Policy::SafeOrder, "safe_order"},
                                                                         {Policy::MutualExclusion, "mutex"},
                                                                         {Policy::None, "none"}}};

std::string conflictWords(const automata::StateSpace& space, const automata::Problem& problem) {
  std::vector<std::string> names;
  for (const auto event : automata::shortestWayIntoConflict(space)) {
    names.push_back(problem.events[event].name);
  }
  return fmt::format(
      "no supervisor can keep the robots out of a conflict that cannot be refused; the shortest sequence "
      "into one: {}. Make the events there controllable, or change the programs",
      names.empty() ? "the start" : fmt::format("{}", fmt::join(names, ", ")));
}

/// Of the problem's events those that never happen in the automaton.
std::vector<std::string> namesWithout(const automata::Automaton& automaton,
                                      const automata::Problem& problem) {
  std::vector<bool> happens(problem.events.size(), false);
  for (const automata::Transition& transition : automaton.transitions) happens[transition.event] = true;
  std::vector<std::string> names;
  for (std::size_t event = 0; event < happens.size(); ++event) {
    if (!happens[event]) names.push_back(problem.events[event].name);
  }
  return names;
}

enum class Found { Done, TooLarge };

/// Fills in what is found of the part.
Result<Found, std::string> synthesizePart(const PartProblem& part, std::size_t max_states,
                                          PartSupervisor& found) {
  const automata::Composition composition(part.problem());
  const auto space = automata::StateSpace::explore(composition, max_states);
  if (!space) return Found::TooLarge;
  const automata::Synthesis synthesis(*space);
  if (synthesis.empty()) return refuse(conflictWords(*space, part.problem()));
  found.frontier = automata::compile(synthesis, part.problem()).frontier;
  const auto automaton = automata::automatonOf(synthesis, part.problem());
  found.fingerprint =
      automata::canonicalFormOf(automaton, part.problem().events).fingerprint(part.problem().events);
  found.counts = synthesis.counts();
  found.never = namesWithout(automaton, part.problem());
  return Found::Done;
}

Result<PartSupervisor, std::string> supervisorOf(const CellModel& model, const automata::PartOfProblem& part,
                                                 Policy policy, std::size_t max_states) {
  PartSupervisor found;
  found.automata = part.automata;
  found.policy = policy;
  if (policy == Policy::Supervisor) {
    for (const bool is_compressed : {false, true}) {
      found.is_compressed = is_compressed;
      const auto result = synthesizePart(PartProblem(model, part, is_compressed), max_states, found);
      if (!result) return refuse(result.error());
      if (*result == Found::Done) return found;
    }
    found.is_compressed = false;
    found.policy = Policy::SafeOrder;
  }
  if (found.policy == Policy::SafeOrder) {
    const auto objections = automata::SafeOrder::objectionsTo(part.problem);
    if (!objections.empty()) {
      return refuse(fmt::format("{}, so that safe_order cannot decide{}", objections.front(),
                                policy == Policy::Supervisor
                                    ? fmt::format("; and a supervisor has more than max_states = {} states. "
                                                  "Raise max_states, or make that event controllable",
                                                  max_states)
                                    : std::string()));
    }
  }
  return found;
}

}  // namespace

const char* toString(Policy policy) {
  for (const auto& [known, name] : kPolicyNames) {
    if (known == policy) return name;
  }
  return "";
}

std::optional<Policy> policyNamed(std::string_view name) {
  for (const auto& [policy, known] : kPolicyNames) {
    if (known == name) return policy;
  }
  return std::nullopt;
}

Result<std::vector<PartSupervisor>, std::string> synthesizeParts(const CellModel& model, Policy policy,
                                                                 std::size_t max_states) {
  std::vector<PartSupervisor> supervisors;
  for (const automata::PartOfProblem& part : automata::independentParts(model.problem)) {
    auto supervisor = supervisorOf(model, part, policy, max_states);
    if (!supervisor) return refuse(supervisor.error());
    supervisors.push_back(std::move(*supervisor));
  }
  return supervisors;
}

std::vector<automata::Verification> verifyParts(const CellModel& model,
                                                const std::vector<PartSupervisor>& parts,
                                                std::size_t max_states) {
  std::vector<automata::Verification> found;
  for (const PartSupervisor& supervisor : parts) {
    const automata::PartOfProblem part = partOf(model, supervisor);
    if (part.automata.empty()) {
      found.push_back({{"a supervisor has robots and zones that do not belong to the cell"}, {}});
    } else if (supervisor.policy == Policy::Supervisor) {
      const PartProblem problem(model, part, supervisor.is_compressed);
      found.push_back(automata::verify({problem.problem(), supervisor.frontier}, supervisor.fingerprint,
                                       problem.holds(model), {max_states}));
    } else if (supervisor.policy == Policy::SafeOrder) {
      found.push_back({automata::SafeOrder::objectionsTo(part.problem), {}});
    } else {
      found.push_back({{fmt::format("the policy {} guarantees nothing", toString(supervisor.policy))}, {}});
    }
  }
  if (automata::independentParts(model.problem).size() != parts.size()) {
    found.push_back({{"a part of the cell has no supervisor, or several"}, {}});
  }
  return found;
}

}  // namespace cobot_command::cell
