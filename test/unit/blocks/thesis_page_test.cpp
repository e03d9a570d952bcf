// doc/thesis.md lists every text of the thesis's error tables that is another here, and no other: what it
// says of the rest, that it is to the letter, holds.

#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <tuple>

#include "block_goals.h"
#include "source_tree.h"
#include "thesis_rows.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

/// "| 16#11 | change_base, change_tcp | as in the thesis | as it is here |", one for each pair of texts.
std::set<std::string> changedTexts() {
  std::map<std::tuple<int, std::string, std::string>, std::string> blocks_of;
  for (const auto& [row, thesis] : thesisRows()) {
    const ErrorEntry* here = findError(row.first, row.second);
    if (here == nullptr) continue;
    for (const auto& [before, now] : {std::pair(thesis.description, std::string(here->description)),
                                      std::pair(thesis.action, std::string(here->remedy))}) {
      if (before == now) continue;
      std::string& blocks = blocks_of[{row.second, before, now}];
      blocks += (blocks.empty() ? "" : ", ") + std::string(toString(row.first));
    }
  }
  std::set<std::string> lines;
  for (const auto& [text, blocks] : blocks_of) {
    const auto& [id, before, now] = text;
    lines.insert(fmt::format("| 16#{:X} | {} | {} | {} |", id, blocks, before, now));
  }
  return lines;
}

std::set<std::string> listedTexts() {
  std::ifstream page(test_support::inSourceTree("doc/thesis.md"));
  const std::regex row(R"((\| 16#[0-9A-F]+ \| [^|]+ \| [^|]+ \| [^|]+ \|) [^|]+ \|)");
  std::set<std::string> lines;
  for (std::string line; std::getline(page, line);) {
    std::smatch found;
    if (std::regex_match(line, found, row)) lines.insert(found[1]);
  }
  return lines;
}

TEST(ThesisPage, listsTheTextsOfTheErrorTablesThatAreOthersHere) {
  EXPECT_EQ(listedTexts(), changedTexts());
}

/// Nobody who sends goals has a function block of a PLC in his hands.
TEST(Catalogue, namesNothingThatOnlyAPlcHas) {
  const std::regex of_the_plc(R"(\bFB\b|CBT_|[Ff]alling edge)");
  for (const ErrorEntry& entry : errorCatalogue()) {
    for (const char* text : {entry.description, entry.remedy, entry.raised_when}) {
      EXPECT_FALSE(std::regex_search(text, of_the_plc))
          << toString(entry.block) << fmt::format(" 16#{:X}: ", entry.id) << text;
    }
  }
}

template <class Goal>
std::string foundOfCommandId() {
  const auto failures = check(with<Goal>([](auto& goal) { goal.command_id = 1; }));
  return failures.empty() ? "" : failures.front().found;
}

/// Only motions have a queue tag that the layer could choose.
TEST(Catalogue, saysWhatCommandIdZeroMeansToEachBlock) {
  for (const ErrorEntry& entry : errorCatalogue()) {
    if (entry.id != motion_error::kCommandIdRange) continue;
    const bool moves = entry.block <= kBlock<MoveCircleGoal>;
    EXPECT_THAT(entry.raised_when, HasSubstr(moves ? "0 (the layer chooses)" : "0 (none)"))
        << toString(entry.block);
  }
  EXPECT_EQ(foundOfCommandId<MoveCircleGoal>(), "command_id is 1; 0 lets the layer choose");
  EXPECT_EQ(foundOfCommandId<ChangeBaseGoal>(), "command_id is 1; 0 gives none");
  EXPECT_EQ(foundOfCommandId<ChangeTcpGoal>(), "command_id is 1; 0 gives none");
  EXPECT_EQ(foundOfCommandId<ProgramControlGoal>(), "command_id is 1; 0 gives none");
}

/// A range in a text is the one that is checked: 16#25 and 16#26 go by the format, not by the movement.
TEST(Catalogue, namesNoMovementWhereTheFormatSaysTheRange) {
  for (const ErrorEntry& entry : errorCatalogue()) {
    if (std::string(entry.description).find("Speed range") == std::string::npos) continue;
    EXPECT_THAT(entry.description, ::testing::Not(::testing::ContainsRegex("Line|PTP|Circle")));
    EXPECT_THAT(entry.description, HasSubstr("above 0"));
  }
}

}  // namespace
}  // namespace cobot_command::testing
