#include "cobot_command/cell/schedule/schedule.h"

#include <algorithm>
#include <utility>

#include "compaction.h"
#include "search.h"
#include "workload.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using automata::Problem;

void addHold(ZoneOrder& order, const Workload& work, const CycleHold& hold,
             const std::vector<std::vector<Duration>>& times) {
  const Workload::Robot& robot = work.robots[hold.robot];
  ScheduledHold scheduled;
  scheduled.robot = robot.plant;
  if (hold.booking) {
    scheduled.booking = robot.events[*hold.booking];
    scheduled.from = times[hold.robot][*hold.booking];
  }
  if (hold.decision) scheduled.decision = robot.events[*hold.decision];
  scheduled.until = times[hold.robot][hold.release.value_or(robot.size() - 1)];
  order.holds.push_back(scheduled);
}

std::vector<ZoneOrder> ordersOf(const Workload& work, const std::vector<Move>& moves) {
  std::vector<std::vector<Duration>> times(work.robots.size());
  for (const Move& move : moves) times[move.robot].push_back(move.at);
  const auto holds = holdsInOrder(work, moves);
  std::vector<ZoneOrder> orders;
  for (std::size_t zone = 0; zone < holds.size(); ++zone) {
    orders.push_back({work.zones[zone].automaton, {}});
    for (const CycleHold& hold : holds[zone]) addHold(orders.back(), work, hold, times);
  }
  return orders;
}

Schedule scheduleOf(const Workload& work, const std::vector<Move>& moves) {
  Schedule schedule;
  std::vector<std::size_t> counts(work.robots.size(), 0);
  std::vector<Duration> times(work.robots.size(), Duration{});
  for (const Move& move : moves) {
    const Workload::Robot& robot = work.robots[move.robot];
    const std::size_t index = counts[move.robot]++;
    const Duration waited = move.at - times[move.robot] - robot.after[index];
    schedule.events.push_back({robot.plant, robot.events[index], move.at, waited});
    schedule.makespan = std::max(schedule.makespan, move.at);
    times[move.robot] = move.at;
  }
  schedule.zones = ordersOf(work, moves);
  return schedule;
}

Result<FoundSchedule, std::string> find(const Problem& problem, const Rule& rule,
                                        const automata::Tuple& initial, const std::vector<RobotCycle>& cycles,
                                        const ScheduleLimits& limits) {
  const auto faults = faultsOfCycles(problem, cycles);
  if (!faults.empty()) return refuse(fmt::format("{}", fmt::join(faults, "\n")));
  const Workload work = workloadOf(problem, cycles);
  Search search(work, rule, initial);
  search.run(limits);
  FoundSchedule found;
  found.bound = search.bound();
  found.expanded = search.expanded();
  for (const auto& robot : work.robots) found.one_after_the_other += robot.length();
  if (search.hasFound()) {
    found.best = scheduleOf(work, compacted(work, search.moves(), rule, initial));
  } else if (search.isExhausted()) {
    return refuse(std::string("there is no schedule: in no order do all these cycles end at home"));
  }
  return found;
}

}  // namespace

Result<FoundSchedule, std::string> findSchedule(const automata::Supervisor& supervisor,
                                                const std::vector<RobotCycle>& cycles,
                                                const ScheduleLimits& limits) {
  const auto rule = [&](const automata::Tuple& state, automata::EventIndex event) {
    return supervisor.decide(state, event);
  };
  return find(supervisor.compiled().problem, rule, supervisor.initial(), cycles, limits);
}

Result<FoundSchedule, std::string> findSchedule(const automata::SafeOrder& rule,
                                                const std::vector<RobotCycle>& cycles,
                                                const ScheduleLimits& limits) {
  const auto decide = [&](const automata::Tuple& state, automata::EventIndex event) {
    return rule.decide(state, event);
  };
  return find(rule.problem(), decide, rule.initial(), cycles, limits);
}

}  // namespace cobot_command::cell
