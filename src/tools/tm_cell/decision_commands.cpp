#include "decision_commands.h"

#include <chrono>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "cobot_command/automata/safe_order.h"
#include "cobot_command/cell/artifact/artifact_schedule.h"
#include "cobot_command/cell/model/part_rules.h"
#include "cobot_command/cell/model/rules.h"
#include "cobot_command/cell/schedule/gantt.h"
#include "cobot_command/cell/schedule/period.h"
#include "cobot_command/cell/schedule/schedule.h"
#include "cobot_command/cell/schedule/zone_orders.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::tools {

using runtime::readArtifact;
namespace {

using Verdict = automata::Decision::Verdict;

std::optional<automata::EventIndex> eventNamed(const automata::Problem& problem, const std::string& name) {
  for (automata::EventIndex event = 0; event < problem.events.size(); ++event) {
    if (problem.events[event].name == name) return event;
  }
  return std::nullopt;
}

std::string unknown(const automata::Problem& problem, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& event : problem.events) names.push_back(event.name);
  return fmt::format("there is no event \"{}\"; the cell has {}", foreignText(name, kQuoteLimit),
                     fmt::join(names, " "));
}

/// Why an event is not granted, for people.
std::string reasonOf(const cell::Rules& rules, const automata::Tuple& state,
                     const automata::Decision& decision) {
  const cell::CellModel& model = rules.model();
  switch (decision.verdict) {
    case Verdict::Granted:
      return "granted";
    case Verdict::NotInPlants:
      return fmt::format("not now: {} is at {}", model.problem.automata[*decision.automaton].name,
                         model.places[*decision.automaton][state[*decision.automaton]].name);
    case Verdict::SpecBlocks: {
      const cell::ZoneIndex zone = *decision.automaton - model.robots();
      const auto holder = model.holder(zone, state[*decision.automaton]);
      return fmt::format("ZONE_HELD: {} is held by {}", model.program.zones[zone],
                         holder ? model.program.robots[*holder].name : "no robot");
    }
    case Verdict::WouldBlock: {
      if (const auto intrusion = rules.intrusionIn(decision.next)) {
        return fmt::format("WOULD_BLOCK: {} could not be kept out of {}, which {} would hold",
                           model.program.robots[intrusion->mechanism].name,
                           model.program.zones[intrusion->zone],
                           model.program.robots[intrusion->holder].name);
      }
      std::vector<std::string> names;
      for (const auto robot : rules.stuckIn(decision.next)) names.push_back(model.program.robots[robot].name);
      return fmt::format("WOULD_BLOCK: {} could not all return home from there", fmt::join(names, ", "));
    }
    case Verdict::UnknownEvent:
    case Verdict::BreaksSpec:
      break;
  }
  return "it cannot happen here";
}

void addRules(const cell::PartRules& part, cell::Policy policy, AnswerStage& stage) {
  const std::string robots = fmt::format("{}", fmt::join(part.robots, ", "));
  stage.faults.insert(stage.faults.end(), part.faults.begin(), part.faults.end());
  if (policy != cell::Policy::Supervisor) {
    stage.report.push_back(
        fmt::format("{}: {} decides, which has no table of states and no rules. Build with --policy "
                    "supervisor and a larger max_states",
                    robots, toString(policy)));
    return;
  }
  for (const std::string& rule : part.rules) stage.report.push_back(rule);
  if (!part.faults.empty()) return;
  if (part.rules.empty()) {
    stage.report.push_back(fmt::format("{}: zones alone are enough, nothing else is refused", robots));
  } else {
    stage.report.push_back(
        fmt::format("{}: {} rules for {} states to avoid; checked in each of {} reachable states, they "
                    "refuse the same {} events and no other",
                    robots, part.rules.size(), part.frontier, part.states, part.refused));
  }
}

}  // namespace

Answer explainEvent(const std::string& artifact_file, const std::vector<std::string>& happened,
                    const std::string& event) {
  const auto artifact = readArtifact(artifact_file);
  if (!artifact) return {{{"explain", 0.0, {}, artifact.error()}}};
  auto model = cell::modelOf(artifact->program);
  if (!model) return {{{"explain", 0.0, {}, model.error()}}};
  const cell::Rules rules(std::move(*model), artifact->supervisors, artifact->policy);
  automata::Tuple state = rules.initial();
  AnswerStage stage{"explain", 0.0, {}, {}};
  std::vector<std::string> events = happened;
  events.push_back(event);
  for (const std::string& name : events) {
    const auto index = eventNamed(rules.model().problem, name);
    if (!index) return wrong("explain", unknown(rules.model().problem, name));
    automata::Decision decision = rules.decide(state, *index);
    stage.report.push_back(fmt::format("{}: {}", name, reasonOf(rules, state, decision)));
    if (decision.verdict != Verdict::Granted) {
      stage.faults.push_back(fmt::format("{} is not granted", name));
      break;
    }
    state = std::move(decision.next);
  }
  return {{std::move(stage)}};
}

Answer tellRules(const std::string& artifact_file) {
  const auto begin = Clock::now();
  const auto artifact = readArtifact(artifact_file);
  if (!artifact) return {{{"rules", 0.0, {}, artifact.error()}}};
  const auto model = cell::modelOf(artifact->program);
  if (!model) return {{{"rules", 0.0, {}, model.error()}}};
  AnswerStage stage{"rules", 0.0, {}, {}};
  const auto max_states = static_cast<std::size_t>(artifact->parameters.max_states);
  const auto parts = rulesOfParts(*model, artifact->supervisors, max_states);
  for (std::size_t part = 0; part < parts.size(); ++part) {
    addRules(parts[part], artifact->supervisors[part].policy, stage);
  }
  stage.seconds = secondsSince(begin);
  return {{std::move(stage)}};
}

Answer scheduleCell(const std::string& artifact_file, double seconds) {
  const auto begin = Clock::now();
  const auto artifact = readArtifact(artifact_file);
  if (!artifact) return {{{"schedule", 0.0, {}, artifact.error()}}};
  const auto model = cell::modelOf(artifact->program);
  if (!model) return {{{"schedule", 0.0, {}, model.error()}}};
  const auto cycles = cell::cyclesOf(*artifact, *model);
  if (!cycles) return wrong("schedule", cycles.error());
  const cell::ScheduleLimits limits{2000000, [&] { return secondsSince(begin) > seconds; }};
  const auto found = cell::scheduleOf(*artifact, *model, *cycles, limits);
  if (!found) return wrong("schedule", found.error());
  AnswerStage stage{"schedule", secondsSince(begin), {}, {}};
  stage.report.push_back(
      fmt::format("{:.3f} s for one cycle of all; one after the other {:.3f} s; no schedule is shorter than "
                  "{:.3f} s{}",
                  toSeconds(found->best->makespan), toSeconds(found->one_after_the_other),
                  toSeconds(found->bound), found->isOptimal() ? ": this is the shortest" : ""));
  const auto orders = countZoneOrders(model->problem, *cycles);
  if (orders.circular) {
    stage.report.push_back(
        fmt::format("{} orders on the zones, {} of them circular", orders.orders, *orders.circular));
  }
  if (const auto period = leastPeriod(model->problem, *cycles)) {
    stage.report.push_back(fmt::format("at least {:.3f} s from cycle to cycle", toSeconds(*period)));
  }
  std::istringstream gantt(ganttOf(*found->best, model->problem));
  for (std::string line; std::getline(gantt, line);) stage.report.push_back(line);
  return {{std::move(stage)}};
}

}  // namespace cobot_command::tools
