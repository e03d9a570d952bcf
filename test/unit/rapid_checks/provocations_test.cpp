// Each finding of checking: its shortest provocation, its place and its text. doc/rapid-findings.md is made
// of the same tables:
//
//   COBOT_MAKE_PAGES=1 build/test/unit/rapid_checks/test_rapid_checks --gtest_filter='*Page*'
#include "../rapid_source/provocations.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>

#include "check_kinds.h"
#include "check_provocations.h"
#include "checked_text.h"
#include "source_tree.h"
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::SizeIs;

TEST(RapidCheckFindings, areProvokedByTheShortestTextAndNothingElseIsFound) {
  for (const CheckProvocation& row : checkProvocations()) {
    const FramedText framed = frame(row.text);
    const CheckedProgram checked = checkedText(framed.text, frameOptions(), row.dialect);
    const Source& source = checked.draft->source(kPredefinedFiles);
    ASSERT_THAT(checked.findings.front(), SizeIs(1))
        << row.id << ' ' << row.text << ' '
        << ::testing::PrintToString(idsAndPlaces(source, checked.findings.front()));
    const Finding& finding = checked.findings.front().front();
    const Place place = source.placeOf(finding.span.begin);
    EXPECT_EQ(finding.id, row.id) << row.text;
    EXPECT_EQ(finding.text, row.message) << row.text;
    EXPECT_EQ(place.line - framed.line + 1, row.line) << row.id << ' ' << row.text;
    EXPECT_EQ(place.column, row.column) << row.id << ' ' << row.text;
    EXPECT_EQ(checked.program == nullptr, finding.severity() == Severity::Error) << row.text;
  }
}

TEST(RapidCheckFindings, haveAProvocationForEachKind) {
  for (const FindingKind& kind : kinds::kCheckFindings) {
    const bool is_of_other_test = kind.id == kinds::kSignalFile.id || kind.id == kinds::kManyModules.id;
    const bool is_provoked = std::any_of(checkProvocations().begin(), checkProvocations().end(),
                                         [&](const CheckProvocation& row) { return row.id == kind.id; });
    EXPECT_NE(is_provoked, is_of_other_test) << kind.id;
  }
}

TEST(RapidCheckFindings, haveAFrameWithoutFindings) {
  const CheckedProgram checked = checkedText(frame("a:=1;").text, frameOptions());
  EXPECT_THAT(checked.findings.front(), SizeIs(0));
}

TEST(RapidCheckFindings, includeProgramsOfTooManyModules) {
  std::string text = withMain("");
  for (std::size_t i = 1; i < kMostModules; ++i) text += "MODULE m" + std::to_string(i) + " ENDMODULE\n";
  EXPECT_THAT(checkedText(text).findings.front(), SizeIs(0));
  const CheckedProgram checked = checkedText(text + "MODULE more ENDMODULE\nMODULE last ENDMODULE\n");
  ASSERT_THAT(checked.findings.front(), SizeIs(1));
  EXPECT_EQ(checked.findings.front().front().text, "a program has at most 64 modules");
}

/// A text in a table of a page, on one line.
std::string cell(const std::string& text, std::size_t most) {
  const bool is_long = text.size() > most;
  std::string shown;
  for (const char c : text.substr(0, is_long ? most : text.size())) {
    shown += c == '\n' ? " " : c == '|' ? "\\|" : std::string(1, c);
  }
  if (is_long) shown += "\xE2\x80\xA6";
  return shown.empty() ? "\xE2\x80\x93" : "`" + shown + "`";
}

std::string rowsOfPage() {
  std::map<std::string_view, std::string> rows;
  const auto add = [&](std::string_view id, const std::string& text, std::string_view message) {
    constexpr std::size_t kMostMessage = 140;
    constexpr std::size_t kMostExample = 52;
    // Files as a whole have no short example.
    const std::string example = id[1] == '9' ? "" : text;
    rows.emplace(id, "| " + std::string(id) + " | " + cell(std::string(message), kMostMessage) + " | " +
                         cell(example, kMostExample) + " |\n");
  };
  for (const Provocation& row : provocations()) add(row.id, row.text, row.message);
  for (const CheckProvocation& row : checkProvocations()) add(row.id, row.text, row.message);
  add("E327", "", "a program has at most 64 modules");
  add("E905", "", "signal file: di at ControlBox 0 is used twice");
  // By number: W306 is next to E306.
  std::vector<std::pair<std::string_view, std::string>> ordered(rows.begin(), rows.end());
  std::sort(ordered.begin(), ordered.end(), [](const auto& left, const auto& right) {
    return std::pair(left.first.substr(1), left.first) < std::pair(right.first.substr(1), right.first);
  });
  std::string table;
  for (const auto& [id, row] : ordered) table += row;
  return table;
}

TEST(RapidFindingsPage, isMadeOfTheTable) {
  const std::string path = test_support::inSourceTree("doc/rapid-findings.md");
  std::ifstream file(path);
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::string head = "| id | text | example |\n|---|---|---|\n";
  const std::size_t begin = page.find(head);
  ASSERT_NE(begin, std::string::npos);
  const std::string made = page.substr(0, begin) + head + rowsOfPage();
  if (std::getenv("COBOT_MAKE_PAGES") != nullptr) {
    std::ofstream(path) << made;
  } else {
    EXPECT_EQ(page, made) << "see the first lines of " << __FILE__;
  }
}

}  // namespace
}  // namespace cobot_command::rapid
