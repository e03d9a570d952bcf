// The shortest schedule: beside one that is found by trying everything, and within its limits.
#include "cobot_command/cell/schedule/schedule.h"

#include <map>

#include "every_second.h"
#include "random_cells.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

using namespace std::chrono_literals;
using test_support::a1;
using test_support::a2a;
using test_support::problemOf;
using test_support::ring;

FoundSchedule found(const automata::Problem& problem, const std::vector<RobotCycle>& cycles,
                    const ScheduleLimits& limits = {}) {
  const auto schedule = findSchedule(*supervisorOf(problem), cycles, limits);
  EXPECT_TRUE(schedule) << schedule.error();
  return schedule ? *schedule : FoundSchedule{};
}

/// All that a schedule promises, looked at event by event.
void expectToHold(const Schedule& schedule, const automata::Supervisor& supervisor,
                  const std::vector<RobotCycle>& cycles) {
  const automata::Problem& problem = supervisor.compiled().problem;
  automata::Tuple state = supervisor.initial();
  std::map<std::size_t, std::pair<std::size_t, Duration>> last;
  Duration now{};
  for (const ScheduledEvent& event : schedule.events) {
    const automata::Decision decision = supervisor.decide(state, event.event);
    ASSERT_EQ(decision.verdict, automata::Decision::Verdict::Granted) << problem.events[event.event].name;
    state = decision.next;
    EXPECT_GE(event.at, now);
    now = event.at;
    const auto cycle = std::find_if(cycles.begin(), cycles.end(),
                                    [&](const RobotCycle& one) { return one.robot == event.robot; });
    ASSERT_NE(cycle, cycles.end());
    auto& [count, before] = last[event.robot];
    ASSERT_LT(count, cycle->events.size());
    EXPECT_EQ(cycle->events[count].event, event.event);
    EXPECT_EQ(event.at, before + cycle->events[count].after + event.waited);
    EXPECT_GE(event.waited, 0s);
    EXPECT_TRUE(problem.events[event.event].controllable || event.waited == 0s);
    ++count;
    before = event.at;
  }
  for (const RobotCycle& cycle : cycles) EXPECT_EQ(last[cycle.robot].first, cycle.events.size());
  EXPECT_EQ(schedule.makespan, now);
  for (const ZoneOrder& zone : schedule.zones) {
    Duration free{};
    for (const ScheduledHold& hold : zone.holds) {
      EXPECT_GE(hold.from, free) << problem.automata[zone.zone].name;
      EXPECT_GE(hold.until, hold.from);
      free = hold.until;
    }
  }
}

TEST(Schedule, ofTheOraclesHoldsWhatItPromises) {
  for (const auto& [problem, gaps, makespan] :
       {std::tuple(a1(), kGapsOfA1, 16s), std::tuple(a2a(), kGapsOfA2a, 19s),
        std::tuple(ring(3), kGapsOfA2a, 26s)}) {
    const auto cycles = cyclesWithGaps(problem, gaps);
    const FoundSchedule schedule = found(problem, cycles);
    ASSERT_TRUE(schedule.isOptimal());
    EXPECT_EQ(schedule.gap(), 0s);
    EXPECT_EQ(schedule.best->makespan, makespan);
    expectToHold(*schedule.best, *supervisorOf(problem), cycles);
  }
}

TEST(Schedule, saysWhoHoldsTheZoneOfA1BeforeWhom) {
  const auto problem = a1();
  const FoundSchedule schedule = found(problem, cyclesWithGaps(problem, kGapsOfA1));
  ASSERT_EQ(schedule.best->zones.size(), 1U);
  const auto& holds = schedule.best->zones.front().holds;
  ASSERT_EQ(holds.size(), 2U);
  EXPECT_NE(holds[0].robot, holds[1].robot);
  EXPECT_EQ(holds[0].from, 2s);
  EXPECT_EQ(holds[0].until, 8s);
  EXPECT_EQ(holds[1].from, 8s);
  EXPECT_EQ(holds[1].until, 14s);
}

TEST(Schedule, isAsShortAsTryingEverythingFinds) {
  Chance chance(1301);
  const int runs = 300;
  int scheduled = 0;
  for (int run = 0; run < runs; ++run) {
    const std::size_t robots = 2 + below(chance, 2);
    const RandomCell cell = randomCell(chance, robots, robots == 2 ? 3 : 2);
    const auto supervisor = supervisorOf(cell.problem);
    if (!supervisor) continue;
    const auto schedule = findSchedule(*supervisor, cell.cycles);
    const auto expected = EverySecond(*supervisor, cell.cycles).makespan();
    ASSERT_EQ(schedule.has_value(), expected.has_value()) << "run " << run;
    if (!schedule) continue;
    ASSERT_TRUE(schedule->isOptimal()) << "run " << run;
    EXPECT_EQ(schedule->best->makespan, std::chrono::seconds(*expected)) << "run " << run;
    EXPECT_LE(schedule->best->makespan, schedule->one_after_the_other);
    expectToHold(*schedule->best, *supervisor, cell.cycles);
    ++scheduled;
  }
  EXPECT_GT(scheduled, runs * 5 / 6);
}

TEST(Schedule, boundsTheShortestOneFromBothSidesWhereALimitEndsTheSearch) {
  Chance chance(1302);
  int with_gap = 0;
  for (int run = 0; run < 60; ++run) {
    const RandomCell cell = randomCell(chance, 3, 3);
    const auto supervisor = supervisorOf(cell.problem);
    if (!supervisor) continue;
    const auto whole = findSchedule(*supervisor, cell.cycles);
    if (!whole) continue;
    Duration bound{};
    for (const std::size_t limit : {0U, 1U, 2U, 4U, 8U, 16U, 64U, 256U, 1024U}) {
      const auto part = findSchedule(*supervisor, cell.cycles, {limit, {}});
      ASSERT_TRUE(part) << part.error();
      EXPECT_LE(part->expanded, limit);
      EXPECT_LE(part->bound, whole->best->makespan);
      EXPECT_GE(part->bound, bound);
      bound = part->bound;
      if (!part->best) continue;
      EXPECT_GE(part->best->makespan, whole->best->makespan);
      expectToHold(*part->best, *supervisor, cell.cycles);
      if (part->gap() > 0s) ++with_gap;
    }
  }
  EXPECT_GT(with_gap, 20);
}

TEST(Schedule, endsWithTheBestFoundWhenItsTimeIsOver) {
  const auto problem = ring(5);
  int asked = 0;
  const FoundSchedule schedule =
      found(problem, cyclesWithGaps(problem, kGapsOfA2a), {1000000, [&] { return ++asked > 1; }});
  EXPECT_EQ(asked, 2);
  ASSERT_TRUE(schedule.best);
  EXPECT_GE(schedule.gap(), 0s);
  EXPECT_LE(schedule.expanded, 64U);
}

TEST(Schedule, letsRobotsWaitBeforeTheZoneAndNotAtHome) {
  const auto problem = ring(5);
  const FoundSchedule schedule = found(problem, cyclesWithGaps(problem, kGapsOfA2a));
  for (const ScheduledEvent& event : schedule.best->events) {
    const std::string& name = problem.events[event.event].name;
    EXPECT_TRUE(event.waited == 0s || name.find("_b_") != std::string::npos) << name;
  }
}

TEST(Schedule, isTheSameEachTime) {
  const auto problem = ring(4);
  const auto cycles = cyclesWithGaps(problem, kGapsOfA2a);
  const FoundSchedule one = found(problem, cycles);
  const FoundSchedule other = found(problem, cycles);
  EXPECT_EQ(one.expanded, other.expanded);
  ASSERT_EQ(one.best->events.size(), other.best->events.size());
  for (std::size_t index = 0; index < one.best->events.size(); ++index) {
    EXPECT_EQ(one.best->events[index].event, other.best->events[index].event);
    EXPECT_EQ(one.best->events[index].at, other.best->events[index].at);
  }
}

TEST(Schedule, isAsShortInWhicheverOrderTheRobotsAreNamed) {
  Chance chance(1303);
  for (int run = 0; run < 40; ++run) {
    RandomCell cell = randomCell(chance, 3, 3);
    const auto supervisor = supervisorOf(cell.problem);
    if (!supervisor) continue;
    const auto one = findSchedule(*supervisor, cell.cycles);
    std::reverse(cell.cycles.begin(), cell.cycles.end());
    const auto other = findSchedule(*supervisor, cell.cycles);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    EXPECT_EQ(one->best->makespan, other->best->makespan);
  }
}

TEST(Schedule, isFoundUnderASafeOrderToo) {
  const auto problem = ring(3);
  const auto cycles = cyclesWithGaps(problem, kGapsOfA2a);
  const auto step_by_step = findSchedule(automata::SafeOrder(problem), cycles);
  ASSERT_TRUE(step_by_step) << step_by_step.error();
  EXPECT_EQ(step_by_step->best->makespan, 26s);
  const automata::SafeOrder banker(problem, automata::SafeOrder::Claim::WholeCycle);
  const auto whole_cycle = findSchedule(banker, cycles);
  ASSERT_TRUE(whole_cycle) << whole_cycle.error();
  EXPECT_GE(whole_cycle->best->makespan, 26s);
  EXPECT_TRUE(whole_cycle->isOptimal());
}

TEST(Schedule, takesNoTimeWhereNothingDoes) {
  const auto problem = ring(3);
  const FoundSchedule schedule = found(problem, cyclesWithGaps(problem, {0, 0, 0, 0, 0, 0, 0}));
  ASSERT_TRUE(schedule.isOptimal());
  EXPECT_EQ(schedule.best->makespan, 0s);
  expectToHold(*schedule.best, *supervisorOf(problem), cyclesWithGaps(problem, {0, 0, 0, 0, 0, 0, 0}));
}

TEST(Schedule, countsNanoseconds) {
  const auto problem = a1();
  const FoundSchedule schedule = found(problem, cyclesWithGaps(problem, {0.1, 1.0 / 3.0, 0, 1e-9, 0.7}));
  const Duration hold = fromSeconds(1.0 / 3.0) + 1ns;
  EXPECT_EQ(schedule.best->makespan, fromSeconds(0.1) + 2 * hold + fromSeconds(0.7));
}

TEST(Schedule, leavesRobotsWithoutACycleAtHome) {
  const auto problem = ring(3);
  auto cycles = cyclesWithGaps(problem, kGapsOfA2a);
  cycles.pop_back();
  const FoundSchedule schedule = found(problem, cycles);
  ASSERT_TRUE(schedule.isOptimal());
  expectToHold(*schedule.best, *supervisorOf(problem), cycles);
}

TEST(Schedule, takesTheWayThatTheCycleNamesWhereAProgramBranches) {
  // RA goes to T1 as in A1, or to T2 and back at once.
  automata::Problem problem = a1();
  automata::Automaton& plant = problem.automata.front();
  plant.states.push_back("RA.T2");
  const auto there = static_cast<automata::EventIndex>(problem.events.size());
  problem.events.push_back({"RA_g_T2", true});
  problem.events.push_back({"RA_r_T2", false});
  plant.alphabet.insert(plant.alphabet.end(), {there, there + 1});
  const auto place = static_cast<automata::StateIndex>(plant.states.size() - 1);
  plant.transitions.push_back({0, there, place});
  plant.transitions.push_back({place, there + 1, 0});
  const RobotCycle other = *cycleWithGaps(problem, 1, kGapsOfA1);
  EXPECT_EQ(found(problem, {{0, {{there, 1s}, {there + 1, 4s}}}, other}).best->makespan, 10s);
  EXPECT_FALSE(cycleWithGaps(problem, 0, kGapsOfA1)) << "gaps do not say which way";
}

TEST(Schedule, saysThatThereIsNoneWhereTheCyclesAreInEachOthersWay) {
  // RB holds the zone at home, rests there, and so never lets RA in.
  auto problem = problemOf("held at home", {{"RA", {"g T", "b Z", "u Z", "r H"}}, {"RB", {"b Z", "u Z"}}});
  problem.automata[1].initial = 1;
  problem.automata[1].marked = {1};
  automata::Automaton& zone = problem.automata[2];
  zone.initial = 2;
  zone.marked = {2};
  const auto supervisor = supervisorOf(problem);
  ASSERT_TRUE(supervisor);
  const auto alone = findSchedule(*supervisor, {*cycleWithGaps(problem, 0, {1, 1, 1})});
  ASSERT_FALSE(alone);
  EXPECT_NE(alone.error().find("there is no schedule"), std::string::npos) << alone.error();
  const auto both =
      findSchedule(*supervisor, {*cycleWithGaps(problem, 0, {1, 1, 1}), *cycleWithGaps(problem, 1, {5})});
  ASSERT_TRUE(both) << both.error();
  EXPECT_FALSE(both->best->zones.front().holds.front().booking) << "it is held from the start";
  EXPECT_EQ(both->best->zones.front().holds.size(), 3U);
}

}  // namespace
}  // namespace cobot_command::cell
