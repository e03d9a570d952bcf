#include "script_port/tag_table.h"

#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

using protocol::TagState;

TEST(TagTable, knowsNothingOfATagThatWasNeverQueued) {
  EXPECT_EQ(TagTable().query(1), TagState::Unknown);
}

TEST(TagTable, reportsATagIncompleteUntilItCompletes) {
  TagTable tags;
  const QueuedTag tag = tags.add(3);
  EXPECT_EQ(tags.query(3), TagState::Incomplete);
  tags.settle(tag, TagTable::Fate::Complete);
  EXPECT_EQ(tags.query(3), TagState::Complete);
}

TEST(TagTable, remembersTheLastFourOnly) {
  TagTable tags;
  for (int tag = 1; tag <= 5; ++tag) (void)tags.add(tag);
  EXPECT_EQ(tags.query(1), TagState::Unknown);
  for (int tag = 2; tag <= 5; ++tag) EXPECT_EQ(tags.query(tag), TagState::Incomplete);
}

TEST(TagTable, answersForTheLatestTagOfANumber) {
  TagTable tags;
  tags.settle(tags.add(7), TagTable::Fate::Complete);
  const QueuedTag again = tags.add(7);
  EXPECT_EQ(tags.query(7), TagState::Incomplete);
  EXPECT_EQ(tags.latest(7)->serial, again.serial);
}

TEST(TagTable, keepsAFailedTagIncompleteButNoLongerOpen) {
  TagTable tags;
  const QueuedTag tag = tags.add(2);
  EXPECT_TRUE(tags.isOpen(tag));
  tags.settle(tag, TagTable::Fate::Failed);
  EXPECT_FALSE(tags.isOpen(tag));
  EXPECT_EQ(tags.query(2), TagState::Incomplete);
}

TEST(TagTable, doesNotKnowATagThatWasForgotten) {
  TagTable tags;
  const QueuedTag tag = tags.add(2);
  tags.forget(tag);
  EXPECT_FALSE(tags.isOpen(tag));
  EXPECT_EQ(tags.query(2), TagState::Unknown);
}

}  // namespace
}  // namespace cobot_command::simulator
