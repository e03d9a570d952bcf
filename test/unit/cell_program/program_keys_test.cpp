// Every key of cell files, misspelt and doubled.
#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include "cell_texts.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

struct KeyAt {
  std::string key;
  std::size_t begin = 0;
  int line = 1;
};

/// What stands in front of a colon in kFull, and is no name.
std::vector<KeyAt> keysIn(const std::string& text) {
  const std::set<std::string> names{"RA", "HOME", "T1", "sheet", "clip", "fence", "PALLET", "OUT", "IN"};
  const std::regex key("([A-Za-z_0-9]+):( |\n)");
  std::vector<KeyAt> keys;
  for (std::sregex_iterator found(text.begin(), text.end(), key), end; found != end; ++found) {
    const auto begin = static_cast<std::size_t>(found->position(1));
    if (names.count(found->str(1)) > 0) continue;
    const auto behind = text.begin() + static_cast<std::ptrdiff_t>(begin);
    keys.push_back({found->str(1), begin, 1 + static_cast<int>(std::count(text.begin(), behind, '\n'))});
  }
  return keys;
}

TEST(CellKeys, thatAreMisspeltAreRefusedWithLineAndTheRightOne) {
  const std::string full = kFull;
  std::set<std::string> seen;
  for (const KeyAt& key : keysIn(full)) {
    seen.insert(key.key);
    const auto cell = parsed(std::string(full).insert(key.begin + key.key.size(), "x"));
    ASSERT_FALSE(cell) << key.key << " of line " << key.line;
    const auto& faults = cell.error();
    const auto told = std::find_if(faults.begin(), faults.end(), [&key](const Fault& fault) {
      return fault.line == key.line && fault.advice == "write " + key.key;
    });
    EXPECT_NE(told, faults.end()) << key.key << " of line " << key.line << "\n" << describe(faults.front());
    if (told == faults.end()) continue;
    EXPECT_EQ(told->file, "cell.yaml");
    EXPECT_THAT(told->field, ::testing::EndsWith(key.key + "x"));
  }
  EXPECT_EQ(seen.size(), 85U) << "keys that cell files have: kFull is to have them all";
}

TEST(CellKeys, thatStandTwiceAreRefusedWithBothLines) {
  const std::string full = kFull;
  for (const KeyAt& key : keysIn(full)) {
    // The key once more, in the line in front of it where it has one of its own.
    const std::size_t line = full.rfind('\n', key.begin) + 1;
    const std::string indent = full.substr(line, key.begin - line);
    if (indent.find_first_not_of(" -") != std::string::npos) continue;
    std::string before = indent + key.key + ": 1\n";
    std::string text = full;
    text.replace(line, key.begin - line, before + std::string(indent.size(), ' '));
    const auto cell = parsed(text);
    ASSERT_FALSE(cell) << key.key;
    const auto& faults = cell.error();
    const std::string words = fmt::format("first in line {}", key.line);
    EXPECT_TRUE(std::any_of(faults.begin(), faults.end(),
                            [&](const Fault& fault) {
                              return fault.line == key.line + 1 &&
                                     fault.found.find(words) != std::string::npos;
                            }))
        << key.key << " of line " << key.line << "\n"
        << describe(faults.front());
  }
}

TEST(CellKeys, thatAreNamesStandOnceToo) {
  for (const char* name : {"  RA: 5\n", "  RB: 5\n"}) {
    for (const char* map : {"robots:\n", "stations:\n", "programs:\n"}) {
      const std::string faults = faultsOf(with(kExample, map, std::string(map) + name));
      EXPECT_THAT(faults, ::testing::HasSubstr("is twice in ")) << name << map;
    }
  }
}

}  // namespace
}  // namespace cobot_command::cell
