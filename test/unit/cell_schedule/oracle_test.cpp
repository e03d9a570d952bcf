// Every figure of the schedules in the data file, which two independent programs have found.
#include "cobot_command/cell/schedule/oracle.h"

#include <fstream>
#include <sstream>

#include "source_tree.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

TEST(ScheduleOracles, areFoundByTheSearchToo) {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("test/data/cell-oracles.json")).rdbuf();
  const auto figures = compareSchedulesWithOracles(text.str());
  ASSERT_TRUE(figures) << figures.error();
  EXPECT_EQ(figures->size(), 20U);
  for (const automata::OracleFigure& figure : *figures) {
    EXPECT_EQ(figure.expected, figure.found) << figure.problem << ": " << figure.figure;
  }
}

TEST(ScheduleOracles, refuseWhatCannotBeRead) {
  EXPECT_FALSE(compareSchedulesWithOracles("{"));
  EXPECT_FALSE(compareSchedulesWithOracles("[]"));
}

}  // namespace
}  // namespace cobot_command::cell
