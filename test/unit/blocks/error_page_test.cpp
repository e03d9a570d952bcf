// doc/errors.md is the error catalogue, row by row: what a user reads is what the code does.

#include <fstream>
#include <sstream>
#include <string>

#include "source_tree.h"
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_catalogue.h"

namespace cobot_command::testing {
namespace {

std::string page() {
  std::string text =
      "# Errors\n\n"
      "`error_id` of a result, by action. The thesis writes ids in hexadecimal (16#10 is 0x10 = 16); ids "
      "from 16#200 "
      "on are\nthis layer's own. Those of `load_path` from 1000 on are of the manual of that instruction, "
      "and "
      "decimal as there.\nThe first violated row of a table decides the id (of `load_path` 1000 before 1005, "
      "and these before 1001 to 1003 and all others);\nthe description names what was found.\n";
  const char* block = "";
  for (const blocks::ErrorEntry& entry : blocks::errorCatalogue()) {
    if (block != std::string(toString(entry.block))) {
      block = toString(entry.block);
      text += fmt::format(
          "\n## `{}`\n| id | decimal | description | remedy | raised when |\n|---|---|---|---|---|\n", block);
    }
    text += fmt::format("| {} | {} | {} | {} | {} |\n", blocks::errorNumber(entry.id), entry.id,
                        entry.description, entry.remedy, entry.raised_when);
  }
  return text;
}

TEST(ErrorPage, isTheErrorCatalogue) {
  std::ifstream file(test_support::inSourceTree("doc/errors.md"));
  std::stringstream found;
  found << file.rdbuf();
  EXPECT_EQ(found.str(), page()) << "doc/errors.md has to be:\n" << page();
}

}  // namespace
}  // namespace cobot_command::testing
