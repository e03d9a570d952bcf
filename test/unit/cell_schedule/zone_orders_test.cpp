// Orders on zones: counted, kept at run time, and repeated.
#include "cobot_command/cell/schedule/zone_orders.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "random_cells.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/schedule/period.h"
#include "cobot_command/cell/schedule/schedule_order.h"

namespace cobot_command::cell {
namespace {

using namespace std::chrono_literals;
using automata::EventIndex;
using test_support::a1;
using test_support::a2a;
using test_support::ring;

FoundSchedule found(const automata::Problem& problem, const std::vector<RobotCycle>& cycles) {
  return *findSchedule(*supervisorOf(problem), cycles);
}

TEST(ZoneOrders, areCountedAsFarAsTheyAreLookedAt) {
  const auto problem = ring(5);
  const auto cycles = cyclesWithGaps(problem, kGapsOfA2a);
  const ZoneOrderCounts all = countZoneOrders(problem, cycles);
  EXPECT_EQ(all.orders, 32U);
  EXPECT_EQ(all.circular, 2U);
  const ZoneOrderCounts some = countZoneOrders(problem, cycles, 10);
  EXPECT_EQ(some.orders, 32U);
  EXPECT_EQ(some.circular, std::nullopt);
}

TEST(ZoneOrders, areTooManyToCountInALargeRing) {
  const auto problem = ring(70);
  const ZoneOrderCounts counts = countZoneOrders(problem, cyclesWithGaps(problem, kGapsOfA2a), 1000);
  EXPECT_EQ(counts.orders, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(counts.circular, std::nullopt);
}

TEST(ZoneOrders, ofARobotKeepItsOwn) {
  const auto problem = a1();
  auto cycles = cyclesWithGaps(problem, kGapsOfA1);
  const auto once = cycles[0].events;
  cycles[0].events.insert(cycles[0].events.end(), once.begin(), once.end());
  EXPECT_EQ(countZoneOrders(problem, cycles).orders, 3U) << "RB is first, between, or last";
  EXPECT_EQ(countZoneOrders(problem, cycles).circular, 0U);
}

/// Robots go on and on, each event by chance, under a supervisor and an order.
class EndlessRun {
 public:
  EndlessRun(const automata::Supervisor& supervisor, const std::vector<RobotCycle>& cycles,
             ScheduleOrder order, Chance::result_type seed)
      : supervisor_(supervisor),
        cycles_(cycles),
        order_(std::move(order)),
        chance_(seed),
        state_(supervisor.initial()),
        counts_(cycles.size(), 0) {}

  /// False: nothing can happen any more.
  bool step() {
    std::vector<std::size_t> robots;
    for (std::size_t robot = 0; robot < cycles_.size(); ++robot) {
      if (!order_.allows(nextOf(robot))) continue;
      if (supervisor_.decide(state_, nextOf(robot)).verdict != automata::Decision::Verdict::Granted) continue;
      robots.push_back(robot);
    }
    if (robots.empty()) return false;
    const std::size_t robot = robots[below(chance_, robots.size())];
    const EventIndex event = nextOf(robot);
    state_ = supervisor_.decide(state_, event).next;
    order_.granted(event);
    ++counts_[robot];
    happened_.push_back(event);
    return true;
  }

  [[nodiscard]] const std::vector<EventIndex>& happened() const { return happened_; }

 private:
  [[nodiscard]] EventIndex nextOf(std::size_t robot) const {
    return cycles_[robot].events[counts_[robot] % cycles_[robot].events.size()].event;
  }

  const automata::Supervisor& supervisor_;
  const std::vector<RobotCycle>& cycles_;
  ScheduleOrder order_;
  Chance chance_;
  automata::Tuple state_;
  std::vector<std::size_t> counts_;
  std::vector<EventIndex> happened_;
};

/// On each zone the bookings of the schedule, again and again.
void expectToRepeat(const Schedule& schedule, const std::vector<EventIndex>& happened) {
  for (const ZoneOrder& zone : schedule.zones) {
    std::vector<EventIndex> order;
    for (const ScheduledHold& hold : zone.holds) order.push_back(*hold.decision);
    std::size_t next = 0;
    for (const EventIndex event : happened) {
      if (std::count(order.begin(), order.end(), event) == 0) continue;
      ASSERT_EQ(event, order[next % order.size()]);
      ++next;
    }
    EXPECT_TRUE(order.empty() || next > 0);
  }
}

TEST(ScheduleOrder, isKeptForManyCyclesAndNeverEndsDead) {
  Chance chance(1304);
  for (int cell_number = 0; cell_number < 40; ++cell_number) {
    const RandomCell cell = cell_number == 0 ? RandomCell{ring(3), cyclesWithGaps(ring(3), kGapsOfA2a)}
                                             : randomCell(chance, 3, 3);
    const auto supervisor = supervisorOf(cell.problem);
    if (!supervisor) continue;
    const auto schedule = findSchedule(*supervisor, cell.cycles);
    ASSERT_TRUE(schedule) << schedule.error();
    EndlessRun run(*supervisor, cell.cycles, ScheduleOrder(schedule->best->zones), chance());
    for (int event = 0; event < 2000; ++event) {
      ASSERT_TRUE(run.step()) << "dead behind " << event << " events";
    }
    expectToRepeat(*schedule->best, run.happened());
  }
}

TEST(ScheduleOrder, givesABookingThatCannotWaitItsTurnWithWhatItFollows) {
  // RA's pallet goes into the zone by itself once it is let go.
  auto problem = a1();
  const auto cycles = cyclesWithGaps(problem, kGapsOfA1);
  const EventIndex go = cycles[0].events[0].event;
  const EventIndex booking = cycles[0].events[1].event;
  problem.events[booking].controllable = false;
  const FoundSchedule schedule = found(problem, cycles);
  ASSERT_TRUE(schedule.isOptimal());
  ScheduleOrder order(schedule.best->zones);
  const EventIndex other = cycles[1].events[1].event;
  const bool is_first = schedule.best->zones.front().holds.front().robot == 0;
  EXPECT_EQ(order.allows(go), is_first);
  EXPECT_EQ(order.allows(other), !is_first);
  EXPECT_TRUE(order.allows(booking)) << "a report is never refused";
}

class OrderOfA1 : public testing::Test {
 protected:
  const automata::Problem problem = a1();
  const std::vector<RobotCycle> cycles = cyclesWithGaps(problem, kGapsOfA1);
  const FoundSchedule schedule = found(problem, cycles);
  const std::vector<ScheduledHold>& holds = schedule.best->zones.front().holds;
  const EventIndex first = *holds[0].booking;
  const EventIndex second = *holds[1].booking;
  ScheduleOrder order = ScheduleOrder(schedule.best->zones);
};

TEST_F(OrderOfA1, letsOneBookAfterTheOther) {
  for (int cycle = 0; cycle < 3; ++cycle) {
    EXPECT_TRUE(order.allows(first));
    EXPECT_FALSE(order.allows(second));
    EXPECT_EQ(order.awaits(second), holds[0].robot);
    order.granted(first);
    EXPECT_FALSE(order.allows(first));
    EXPECT_TRUE(order.allows(second));
    order.granted(second);
  }
}

TEST_F(OrderOfA1, hasNothingAgainstWhatBooksNothing) {
  for (const RobotCycle& cycle : cycles) {
    for (const TimedEvent& event : cycle.events) {
      if (event.event == second) continue;
      EXPECT_TRUE(order.allows(event.event));
      if (event.event != first) order.granted(event.event);
    }
  }
  EXPECT_TRUE(order.allows(4711));
}

TEST_F(OrderOfA1, takesATurnBack) {
  order.granted(first);
  order.withdrawn(first);
  EXPECT_TRUE(order.allows(first));
  EXPECT_FALSE(order.allows(second));
  order.granted(first);
  order.granted(second);
  order.withdrawn(second);
  EXPECT_TRUE(order.allows(second));
}

TEST_F(OrderOfA1, isOffBehindAFaultUntilAllAreHome) {
  order.granted(first);
  order.switchOff();
  EXPECT_FALSE(order.isOn());
  EXPECT_TRUE(order.allows(first));
  EXPECT_TRUE(order.allows(second));
  order.granted(second);
  order.allHome();
  EXPECT_TRUE(order.isOn());
  EXPECT_TRUE(order.allows(first));
  EXPECT_FALSE(order.allows(second));
}

TEST_F(OrderOfA1, goesOnWhenAllAreHomeInTheMiddleOfIt) {
  order.granted(first);
  order.allHome();
  EXPECT_TRUE(order.allows(second));
}

TEST(LeastPeriod, ofA1IsTwelveSeconds) {
  const auto problem = a1();
  EXPECT_EQ(leastPeriod(problem, cyclesWithGaps(problem, kGapsOfA1)), 12s);
}

TEST(LeastPeriod, isWhatMoreCyclesTakeMore) {
  for (const auto& [problem, gaps] : {std::pair(a1(), kGapsOfA1), std::pair(a2a(), kGapsOfA2a)}) {
    const auto once = cyclesWithGaps(problem, gaps);
    const Duration period = *leastPeriod(problem, once);
    const Duration one = found(problem, once).best->makespan;
    auto cycles = once;
    for (int more = 1; more <= 3; ++more) {
      for (std::size_t robot = 0; robot < cycles.size(); ++robot) {
        cycles[robot].events.insert(cycles[robot].events.end(), once[robot].events.begin(),
                                    once[robot].events.end());
      }
      EXPECT_LE(found(problem, cycles).best->makespan, one + more * period) << problem.name << ", " << more;
    }
  }
}

TEST(LeastPeriod, isNoLongerThanASchedule) {
  Chance chance(1305);
  for (int run = 0; run < 60; ++run) {
    const RandomCell cell = randomCell(chance, 3, 2);
    const auto supervisor = supervisorOf(cell.problem);
    if (!supervisor) continue;
    const auto schedule = findSchedule(*supervisor, cell.cycles);
    const auto period = leastPeriod(cell.problem, cell.cycles);
    ASSERT_TRUE(schedule);
    ASSERT_TRUE(period);
    EXPECT_LE(*period, schedule->best->makespan);
    for (const RobotCycle& cycle : cell.cycles) {
      Duration alone{};
      for (const TimedEvent& event : cycle.events) alone += event.after;
      EXPECT_GE(*period, alone);
    }
  }
}

TEST(LeastPeriod, isNotToldWhereTooManyOrdersWouldHaveToBeLookedAt) {
  const auto problem = ring(8);
  EXPECT_EQ(leastPeriod(problem, cyclesWithGaps(problem, kGapsOfA2a), 20), std::nullopt);
}

}  // namespace
}  // namespace cobot_command::cell
