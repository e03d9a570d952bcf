// What is refused before anything is scheduled, and with which words.
#include "cobot_command/cell/schedule/robot_cycle.h"

#include <limits>

#include "random_cells.h"
#include <gmock/gmock.h>

#include "cobot_command/cell/schedule/schedule.h"

namespace cobot_command::cell {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Cycles : public testing::Test {
 protected:
  std::vector<std::string> faults() { return faultsOfCycles(problem, cycles); }
  std::string faultOfGaps(const std::vector<double>& gaps) {
    const auto cycle = cycleWithGaps(problem, 0, gaps);
    return cycle ? "" : cycle.error();
  }

  automata::Problem problem = test_support::a1();
  std::vector<RobotCycle> cycles = cyclesWithGaps(problem, kGapsOfA1);
};

TEST_F(Cycles, ofA1HaveNoFaults) {
  EXPECT_THAT(faults(), IsEmpty());
}

TEST_F(Cycles, haveTheGapsBetweenTheirEvents) {
  std::vector<Duration> after;
  for (const TimedEvent& event : cycles.front().events) after.push_back(event.after);
  EXPECT_THAT(after, ElementsAre(0s, 2s, 3s, 0s, 3s, 2s));
}

TEST_F(Cycles, haveToBeThere) {
  EXPECT_THAT(faultsOfCycles(problem, {}), ElementsAre(HasSubstr("nothing to schedule")));
}

TEST_F(Cycles, areOfRobots) {
  cycles = {{17, {}}, {2, {}}, {0, {}}};
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("there is no robot 17"), HasSubstr("Z is a spec"),
                                    HasSubstr("the cycle of RA has no events")));
}

TEST_F(Cycles, areOnePerRobot) {
  cycles[1] = cycles[0];
  EXPECT_THAT(faults(), ElementsAre("RA has two cycles"));
}

TEST_F(Cycles, haveEventsOfTheirRobotOnly) {
  cycles[0].events[1].event = cycles[1].events[1].event;
  EXPECT_THAT(faults(), ElementsAre("event 2 of the cycle of RA: \"RB_b_Z\" is not an event of RA"));
  cycles[0].events[1].event = 99;
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("event 2 of the cycle of RA does not exist")));
}

TEST_F(Cycles, goAsThePlantGoes) {
  cycles[0].events[1] = cycles[0].events[2];
  EXPECT_THAT(faults(), ElementsAre("event 2 of the cycle of RA: RA cannot execute \"RA_r_T1\" at RA.1"));
}

TEST_F(Cycles, endAtHome) {
  cycles[0].events.pop_back();
  EXPECT_THAT(faults(), ElementsAre("the cycle of RA ends at RA.5, not at its home RA.0"));
}

TEST_F(Cycles, takeNoNegativeTimes) {
  cycles[1].events[4].after = -1ns;
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("event 5 of the cycle of RB, \"RB_u_Z\"")));
}

TEST_F(Cycles, areShortEnoughForTheirSums) {
  cycles[0].events[2].after = 600000s;
  EXPECT_THAT(faults(), IsEmpty());
  cycles[1].events[2].after = 600000s;
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("all cycles together take")));
  cycles[1].events[2].after = Duration::max();
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("all cycles together take")));
}

TEST_F(Cycles, haveNoMoreEventsThanFit) {
  const RobotCycle once = cycles[0];
  for (int cycle = 0; cycle < 1000; ++cycle) {
    cycles[0].events.insert(cycles[0].events.end(), once.events.begin(), once.events.end());
  }
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("at most 4000 can be scheduled")));
}

TEST_F(Cycles, shareNoEvents) {
  problem.automata[1].alphabet.push_back(cycles[0].events[0].event);
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("belongs to several plants")));
}

TEST_F(Cycles, haveReportsThatTakeNothingFromOthers) {
  // After RA's release RB may book a second time only if it has booked before: earlier is not better.
  automata::Automaton spec;
  spec.name = "odd";
  spec.kind = automata::Automaton::Kind::Spec;
  spec.states = {"start", "RB first", "both", "RA first"};
  spec.marked = {0, 1, 2, 3};
  const auto release = cycles[0].events[4].event;
  const auto booking = cycles[1].events[1].event;
  spec.alphabet = {release, booking};
  spec.transitions = {{0, booking, 1}, {1, release, 2}, {0, release, 3}};
  problem.automata.push_back(spec);
  EXPECT_THAT(faults(), ElementsAre(HasSubstr("the report \"RA_u_Z\" differs before and after \"RB_b_Z\"")));
}

TEST_F(Cycles, areRefusedByTheSearchInTheSameWords) {
  const auto supervisor = supervisorOf(problem);
  cycles[0].events.pop_back();
  cycles[1].events.pop_back();
  const auto schedule = findSchedule(*supervisor, cycles);
  ASSERT_FALSE(schedule);
  EXPECT_EQ(schedule.error(),
            "the cycle of RA ends at RA.5, not at its home RA.0\nthe cycle of RB ends at RB.5, not at its "
            "home RB.0");
}

TEST_F(Cycles, refuseGapsThatAreNoTimes) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double wrong : {nan, infinite, -infinite, -1.0, -1e-12, 1e7, 1e300}) {
    EXPECT_THAT(faultOfGaps({2, wrong, 0, 3, 2}), HasSubstr("gap 2 of RA")) << wrong;
  }
  EXPECT_THAT(faultOfGaps({2, 3}), HasSubstr("5 gaps between them, but 2"));
  EXPECT_THAT(faultOfGaps({}), HasSubstr("but 0 are given"));
}

TEST_F(Cycles, refuseGapsOfWhatDoesNotComeHome) {
  EXPECT_FALSE(cycleWithGaps(problem, 2, kGapsOfA1));
  EXPECT_FALSE(cycleWithGaps(problem, 20, kGapsOfA1));
  problem.automata[0].transitions.pop_back();
  EXPECT_THAT(faultOfGaps(kGapsOfA1), HasSubstr("RA has no path home from RA.5"));
  problem.automata[0].transitions.push_back({5, cycles[0].events[5].event, 3});
  EXPECT_THAT(faultOfGaps(kGapsOfA1), HasSubstr("RA has no path home"));
}

}  // namespace
}  // namespace cobot_command::cell
