#include "cobot_command/cell/schedule/schedule.h"

#include <algorithm>
#include <utility>

#include "search.h"
#include "workload.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

using automata::Problem;

void addHold(ZoneOrder& order, const Workload& work, const Hold& hold,
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

/// By zone: its holds in the order in which they happen. Those of no length are told apart by the order of
/// the events, as their times are the same.
std::vector<ZoneOrder> ordersOf(const Workload& work, const std::vector<Move>& moves) {
  std::vector<std::vector<Duration>> times(work.robots.size());
  std::vector<std::vector<std::size_t>> ranks(work.robots.size());
  for (std::size_t index = 0; index < moves.size(); ++index) {
    times[moves[index].robot].push_back(moves[index].at);
    ranks[moves[index].robot].push_back(index + 1);
  }
  std::vector<ZoneOrder> orders;
  for (const Workload::Zone& zone : work.zones) {
    std::vector<Hold> holds = zone.holds;
    const auto rankOf = [&](const Hold& hold) { return hold.booking ? ranks[hold.robot][*hold.booking] : 0; };
    std::sort(holds.begin(), holds.end(),
              [&](const Hold& one, const Hold& other) { return rankOf(one) < rankOf(other); });
    ZoneOrder order{zone.automaton, {}};
    for (const Hold& hold : holds) addHold(order, work, hold, times);
    orders.push_back(std::move(order));
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

Result<FoundSchedule, std::string> find(const Problem& problem, Rule rule, const automata::Tuple& initial,
                                        const std::vector<RobotCycle>& cycles, const ScheduleLimits& limits) {
  const auto faults = faultsOfCycles(problem, cycles);
  if (!faults.empty()) return refuse(fmt::format("{}", fmt::join(faults, "\n")));
  const Workload work = workloadOf(problem, cycles);
  Search search(work, std::move(rule), initial);
  search.run(limits);
  FoundSchedule found;
  found.bound = search.bound();
  found.expanded = search.expanded();
  for (const auto& robot : work.robots) found.one_after_the_other += robot.length();
  if (search.hasFound()) {
    found.best = scheduleOf(work, search.moves());
  } else if (search.isExhausted()) {
    return refuse(std::string(
        "there is no schedule: whatever is granted, these cycles do not all come to their end at home"));
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
