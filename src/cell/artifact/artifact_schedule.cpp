#include "cobot_command/cell/artifact/artifact_schedule.h"

#include <utility>

#include "cobot_command/automata/safe_order.h"
#include "cobot_command/cell/artifact/cycle_times.h"

namespace cobot_command::cell {

Result<std::vector<RobotCycle>, std::string> cyclesOf(const Artifact& artifact, const CellModel& model) {
  std::vector<RobotCycle> cycles;
  for (RobotIndex robot = 0; robot < model.robots(); ++robot) {
    auto cycle = cycleOf(artifact, model, robot);
    if (!cycle) return refuse(cycle.error());
    cycles.push_back(std::move(*cycle));
  }
  return cycles;
}

Result<FoundSchedule, std::string> scheduleOf(const Artifact& artifact, const CellModel& model,
                                              const std::vector<RobotCycle>& cycles,
                                              const ScheduleLimits& limits) {
  const auto& parts = artifact.supervisors;
  const bool has_table =
      parts.size() == 1 && parts.front().policy == Policy::Supervisor && !parts.front().is_compressed;
  const auto objections = automata::SafeOrder::objectionsTo(model.problem);
  if (!has_table && !objections.empty()) {
    return refuse(objections.front() +
                  ", and there is no single table for all robots: schedule a cell with only the robots that "
                  "share zones");
  }
  auto found =
      has_table ? findSchedule(automata::Supervisor({model.problem, parts.front().frontier}), cycles, limits)
                : findSchedule(automata::SafeOrder(model.problem), cycles, limits);
  if (found && !found->best) {
    return refuse(std::string("no schedule was found in that time: allow more time"));
  }
  return found;
}

Result<std::vector<std::vector<RobotIndex>>, std::string> turnsOf(const Artifact& artifact,
                                                                  const CellModel& model,
                                                                  const ScheduleLimits& limits) {
  const auto cycles = cyclesOf(artifact, model);
  if (!cycles) return refuse(cycles.error());
  const auto found = scheduleOf(artifact, model, *cycles, limits);
  if (!found) return refuse(found.error());
  std::vector<std::vector<RobotIndex>> turns(model.program.zones.size());
  for (const ZoneOrder& order : found->best->zones) {
    for (const ScheduledHold& hold : order.holds) {
      if (hold.booking) turns[order.zone - model.robots()].push_back(hold.robot);
    }
  }
  return turns;
}

}  // namespace cobot_command::cell
