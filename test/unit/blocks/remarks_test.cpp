// What is to be known of a goal that was carried out all the same, over all of its commands.
#include <gmock/gmock.h>

#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::blocks {
namespace {

Remarks warnedOf(const std::string& line) {
  Remarks remarks;
  remarks.warned_lines = {line};
  return remarks;
}

TEST(Remarks, ofNothingAreNoText) {
  EXPECT_EQ(Remarks().text(), "");
  EXPECT_EQ(Remarks().textOfWarnings(), "");
}

TEST(Remarks, areOneTextOfAllThatIsToBeKnown) {
  Remarks remarks = warnedOf("line 1: a = b");
  remarks.unplanned = "there is no model";
  remarks.unseen = "there is no stream";
  EXPECT_EQ(remarks.text(),
            "sent unplanned and unchecked: there is no model; its end position was not confirmed: there is "
            "no stream; the controller warns of line 1: a = b");
  EXPECT_EQ(remarks.textOfWarnings(), "the controller warns of line 1: a = b");
}

TEST(Remarks, keepTheFirstReasonAndEachWarningOnce) {
  Remarks remarks = warnedOf("line 1: a");
  remarks.unplanned = "first";
  Remarks other = warnedOf("line 1: a");
  other.unplanned = "second";
  remarks.add(other);
  remarks.add(warnedOf("line 2: b"));
  EXPECT_EQ(remarks.unplanned, "first");
  EXPECT_THAT(remarks.warned_lines, ::testing::ElementsAre("line 1: a", "line 2: b"));
}

/// A cycle may run for days, and its scripts be others each time.
TEST(Remarks, doNotGrowWithoutEnd) {
  Remarks remarks;
  for (int i = 0; i < 1000; ++i) remarks.add(warnedOf("line " + std::to_string(i) + std::string(100, 'x')));
  EXPECT_LE(remarks.text().size(), 3000U);
  EXPECT_GE(remarks.warned_lines.size(), 10U);
}

}  // namespace
}  // namespace cobot_command::blocks
