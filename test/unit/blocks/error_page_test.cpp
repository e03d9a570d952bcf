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
      "Each result has an `error_id`; its meaning depends on the action. `16#` marks hexadecimal numbers, as "
      "in the thesis (16#10 is 0x10 = 16).\n\n"
      "- Ids below 16#200 are from the thesis; those of `exchange_configuration` are from SRCI.\n"
      "- Ids from 16#200 on are defined by this package, ids from 16#8000 on are from SRCI.\n"
      "- Ids 1000 to 1061 of `load_path` are from the manual of that instruction, and decimal as in the "
      "manual.\n"
      "- If a goal violates several rows, the first one in its table gives the id. In `load_path`, 1000 "
      "comes before 1005, these before 1001 to 1003, and those before all others.\n"
      "- `error_description` also gives the value that was found, and `remedy` the action to take.\n";
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
  EXPECT_EQ(found.str(), page()) << "doc/errors.md must be:\n" << page();
}

}  // namespace
}  // namespace cobot_command::testing
