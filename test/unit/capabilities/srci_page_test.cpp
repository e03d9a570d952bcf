// The table of doc/srci.md says of each function what the table of the code says, and names no other.

#include <algorithm>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "source_tree.h"
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/capabilities/functions.h"

namespace cobot_command::capabilities {
namespace {

using ::testing::HasSubstr;

std::vector<std::string> split(const std::string& text, const std::string& between) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t at = text.find(between); at != std::string::npos; at = text.find(between, from)) {
    parts.push_back(text.substr(from, at - from));
    from = at + between.size();
  }
  parts.push_back(text.substr(from));
  return parts;
}

/// Without the blanks around them.
std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells = split(line.substr(1, line.rfind('|') - 1), "|");
  for (std::string& cell : cells) {
    const std::size_t begin = cell.find_first_not_of(' ');
    cell = begin == std::string::npos ? "" : cell.substr(begin, cell.find_last_not_of(' ') + 1 - begin);
  }
  return cells;
}

struct Row {
  std::string here;
  std::string supported;  ///< without the marks of code
};

/// The first table, by the names of its first column.
std::map<std::string, Row> rowsOfThePage() {
  std::ifstream file(test_support::inSourceTree("doc/srci.md"));
  std::map<std::string, Row> rows;
  std::string line;
  while (std::getline(file, line) && line.rfind("## ", 0) != 0) {
    if (line.rfind("| ", 0) != 0 || line.rfind("| SRCI |", 0) == 0) continue;
    const auto cells = cellsOf(line);
    if (cells.size() != 3) {
      ADD_FAILURE() << "not three columns: " << line;
      continue;
    }
    std::string supported = cells[2];
    supported.erase(std::remove(supported.begin(), supported.end(), '`'), supported.end());
    for (const std::string& name : split(cells[0], ", ")) rows[name] = {cells[1], supported};
  }
  return rows;
}

std::string supportText(const Function& function) {
  switch (function.offer) {
    case Offer::Whole:
      return "yes";
    case Offer::Partly:
      return fmt::format("yes, but: {}", function.reason);
    case Offer::NotBuilt:
      return "not built yet";
    case Offer::NoWay:
      return fmt::format("no: {}", function.reason);
  }
  return {};
}

TEST(ThePageOfSrci, hasEachFunctionWithItsInterfacesAndWhatIsMissing) {
  const auto rows = rowsOfThePage();
  for (const Function& function : functions()) {
    const auto row = rows.find(std::string(function.srci));
    if (row == rows.end()) {
      ADD_FAILURE() << "doc/srci.md has no row with " << function.srci;
      continue;
    }
    EXPECT_EQ(row->second.supported, supportText(function)) << function.srci;
    if (function.ours.empty()) continue;
    for (const std::string& interface : split(std::string(function.ours), ", ")) {
      const std::string name = interface.substr(interface.find(' ') + 1);
      EXPECT_THAT(row->second.here, HasSubstr("`" + name + "`")) << function.srci;
    }
  }
}

TEST(ThePageOfSrci, namesNoFunctionThatTheCodeDoesNotKnow) {
  for (const auto& [name, row] : rowsOfThePage()) {
    const auto is_it = [&wanted = name](const Function& function) { return function.srci == wanted; };
    EXPECT_TRUE(std::any_of(functions().begin(), functions().end(), is_it))
        << name << " is not in src/capabilities/functions.cpp";
  }
}

}  // namespace
}  // namespace cobot_command::capabilities
