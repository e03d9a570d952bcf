// Every number of the data file, which two independent programs have found.
#include "cobot_command/automata/oracle.h"

#include <fstream>
#include <sstream>

#include "source_tree.h"
#include <gtest/gtest.h>

namespace cobot_command::automata {
namespace {

TEST(CellOracles, areFoundByTheEngineToo) {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("test/data/cell-oracles.json")).rdbuf();
  const auto figures = compareWithOracles(text.str());
  ASSERT_TRUE(figures) << figures.error();
  EXPECT_GT(figures->size(), 300U);
  for (const OracleFigure& figure : *figures) {
    EXPECT_EQ(figure.expected, figure.found) << figure.problem << ": " << figure.figure;
  }
}

}  // namespace
}  // namespace cobot_command::automata
