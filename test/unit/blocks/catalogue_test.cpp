// The form of the error catalogue: as in the thesis, ordered, with one meaning for one id.

#include <map>
#include <set>
#include <string>
#include <utility>

#include "thesis_rows.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;

constexpr int kFirstOwn = 0x200;

/// What their texts have become: thesis_page_test.cpp.
TEST(Catalogue, hasEveryRowOfTheThesis) {
  const auto rows = thesisRows();
  EXPECT_EQ(rows.size(), 88u);
  for (const auto& [row, texts] : rows) {
    EXPECT_NE(findError(row.first, row.second), nullptr) << toString(row.first) << " " << texts.description;
  }
}

/// 16#99 is of annex code, 16#28 checks the command_id that the tables of changes and controls have too.
TEST(Catalogue, addsOnlyTwoIdsBelowItsOwnToTheBlocksOfTheThesis) {
  const auto rows = thesisRows();
  for (const ErrorEntry& entry : errorCatalogue()) {
    if (entry.block > kBlock<ProgramControlGoal> || entry.id >= kFirstOwn) continue;
    if (rows.count({entry.block, entry.id}) != 0) continue;
    EXPECT_TRUE(entry.id == motion_error::kLinkDropped || entry.id == motion_error::kCommandIdRange)
        << toString(entry.block) << " " << entry.id;
  }
}

TEST(Catalogue, hasALostLinkInEveryBlockThatNeedsOne) {
  for (std::size_t i = 0; i < kBlockCount; ++i) {
    const auto block = static_cast<Block>(i);
    const bool without = block == kBlock<ConnectGoal> || block == kBlock<CheckSequenceGoal> ||
                         block == kBlock<ExchangeConfigurationGoal>;  // by a number of its own
    const int id = ownErrorId(block, motion_error::kLinkDropped);
    EXPECT_EQ(findError(block, id) == nullptr, without) << toString(block);
  }
}

TEST(Catalogue, isOrderedByBlockAndIdWithoutDoubles) {
  const auto& all = errorCatalogue();
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LT(std::make_pair(all[i - 1].block, all[i - 1].id), std::make_pair(all[i].block, all[i].id));
  }
  EXPECT_EQ(all.front().block, kBlock<ConnectGoal>);
  EXPECT_EQ(all.back().block, static_cast<Block>(kBlockCount - 1));
}

TEST(Catalogue, findsEachRowAndNoOthers) {
  for (const ErrorEntry& entry : errorCatalogue()) EXPECT_EQ(findError(entry.block, entry.id), &entry);
  for (std::size_t i = 0; i < kBlockCount; ++i) {
    for (const int id : {-1, 0, 0x12, 0x1FF, 0x7FFFFFFF}) {
      EXPECT_EQ(findError(static_cast<Block>(i), id), nullptr) << id;
    }
  }
  EXPECT_EQ(findError(kBlock<ConnectGoal>, motion_error::kNotConnected), nullptr);
}

TEST(Catalogue, leavesNoTextEmpty) {
  for (const ErrorEntry& entry : errorCatalogue()) {
    EXPECT_STRNE(entry.description, "");
    EXPECT_STRNE(entry.remedy, "");
    EXPECT_STRNE(entry.raised_when, "");
  }
}

TEST(Catalogue, givesOwnIdsOneMeaningInAllBlocks) {
  std::map<int, std::string> meaning;
  for (const ErrorEntry& entry : errorCatalogue()) {
    if (entry.id < kFirstOwn) continue;
    const auto [known, added] = meaning.emplace(entry.id, entry.description);
    EXPECT_TRUE(added || known->second == entry.description) << entry.description;
  }
}

}  // namespace
}  // namespace cobot_command::testing
