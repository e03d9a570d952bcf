// The picture of a schedule.
#include "cobot_command/cell/schedule/gantt.h"

#include "random_cells.h"
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using testing::HasSubstr;

std::string gantt(const automata::Problem& problem, const std::vector<double>& gaps, std::size_t columns) {
  const auto schedule = findSchedule(*supervisorOf(problem), cyclesWithGaps(problem, gaps));
  return ganttOf(*schedule->best, problem, columns);
}

TEST(Gantt, ofA1HasALineForEachRobotAndEachZone) {
  EXPECT_EQ(gantt(test_support::a1(), kGapsOfA1, 32),
            "     |0                        16.00 s|\n"
            "1 RA |----############----............|\n"
            "2 RB |----~~~~~~~~~~~~############----|\n"
            "  Z  |....111111111111222222222222....|\n"
            "      - on its way, # in a zone, ~ waits, . at home or free; a column is 0.500 s\n");
}

TEST(Gantt, takesTenColumnsAtLeast) {
  EXPECT_THAT(gantt(test_support::a1(), kGapsOfA1, 0), HasSubstr("2 RB |-~~~~####-|"));
}

TEST(Gantt, isEmptyWhereNothingTakesTime) {
  EXPECT_THAT(gantt(test_support::a1(), {0, 0, 0, 0, 0}, 12), HasSubstr("1 RA |............|"));
}

TEST(Gantt, hasNoMoreSignsThanRobots) {
  const auto problem = test_support::ring(4);
  EXPECT_THAT(gantt(problem, kGapsOfA2a, 40), HasSubstr("4 R4 |"));
}

}  // namespace
}  // namespace cobot_command::cell
