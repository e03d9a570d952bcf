#include "cobot_command/cell/schedule/oracle.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/automata/formats.h"
#include "cobot_command/automata/state_space.h"
#include "cobot_command/automata/synthesis.h"
#include "cobot_command/cell/schedule/schedule.h"
#include "cobot_command/cell/schedule/zone_orders.h"

namespace cobot_command::cell {
namespace {

using automata::OracleFigure;
using automata::Problem;
using nlohmann::json;

/// More than any problem of the file has.
constexpr std::size_t kMaxStates = 1000000;

/// "gaps": {"RA": [2, 3, 0, 3, 2], ...}, by plant.
Result<std::vector<RobotCycle>, std::string> cyclesOf(const Problem& problem, const json& gaps) {
  std::vector<RobotCycle> cycles;
  for (const auto& [name, times] : gaps.items()) {
    std::vector<double> seconds;
    for (const json& time : times) {
      if (!time.is_number()) return refuse(fmt::format("the gaps of {} are not all numbers", name));
      seconds.push_back(time.get<double>());
    }
    std::size_t robot = 0;
    while (robot < problem.automata.size() && problem.automata[robot].name != name) ++robot;
    if (robot == problem.automata.size()) return refuse(fmt::format("there is no robot \"{}\"", name));
    const auto cycle = cycleWithGaps(problem, robot, seconds);
    if (!cycle) return refuse(cycle.error());
    cycles.push_back(*cycle);
  }
  return cycles;
}

Result<FoundSchedule, std::string> scheduleOf(const Problem& problem, const std::vector<RobotCycle>& cycles) {
  const automata::Composition composition(problem);
  const auto space = automata::StateSpace::explore(composition, kMaxStates);
  if (!space) return refuse(fmt::format("more than {} states", kMaxStates));
  const automata::Synthesis synthesis(*space);
  if (synthesis.empty()) return refuse(std::string("its supervisor is empty"));
  return findSchedule(automata::Supervisor(automata::compile(synthesis, problem)), cycles);
}

std::string text(double number) {
  return fmt::format("{:.9g}", number);
}

Result<json, std::string> figuresOf(const Problem& problem, const json& expected) {
  if (!expected.contains("gaps") || !expected["gaps"].is_object()) {
    return refuse(std::string("its schedule has no gaps"));
  }
  const auto cycles = cyclesOf(problem, expected["gaps"]);
  if (!cycles) return refuse(cycles.error());
  const auto found = scheduleOf(problem, *cycles);
  if (!found) return refuse(found.error());
  const ZoneOrderCounts orders = countZoneOrders(problem, *cycles);
  json figures = {{"makespan", "none that is optimal"},
                  {"one_after_the_other", text(toSeconds(found->one_after_the_other))},
                  {"orders", std::to_string(orders.orders)},
                  {"circular_orders", orders.circular ? std::to_string(*orders.circular) : "too many"}};
  if (found->isOptimal()) figures["makespan"] = text(toSeconds(found->best->makespan));
  return figures;
}

}  // namespace

Result<std::vector<OracleFigure>, std::string> compareSchedulesWithOracles(std::string_view file) {
  const auto problems = automata::problemsFromJson(file);
  if (!problems) return refuse(problems.error());
  const json source = json::parse(file, nullptr, false);
  std::vector<OracleFigure> figures;
  for (std::size_t index = 0; index < problems->size(); ++index) {
    const json& entry = source["problems"][index];
    const std::string& name = (*problems)[index].name;
    if (!entry.contains("expected") || !entry["expected"].is_object()) continue;
    if (!entry["expected"].contains("schedule")) continue;
    const json& expected = entry["expected"]["schedule"];
    const auto found = figuresOf((*problems)[index], expected);
    if (!found) return refuse(fmt::format("\"{}\": {}", name, found.error()));
    for (const auto& [key, value] : expected.items()) {
      if (key == "gaps") continue;
      figures.push_back({name, "schedule." + key,
                         value.is_number() ? text(value.get<double>()) : value.dump(),
                         found->value(key, "none")});
    }
  }
  return figures;
}

}  // namespace cobot_command::cell
