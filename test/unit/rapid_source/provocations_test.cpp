// Each finding of reading: its shortest provocation, its place and its text.
#include "provocations.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "source_tree.h"
#include "tree_text.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/source/finding_kinds.h"
#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::rapid {
namespace {

using ::testing::SizeIs;

/// What is no whole file is the line of a routine.
std::string wholeFile(const Provocation& row) {
  const bool is_file = row.text.rfind("MODULE", 0) == 0 || row.text.front() == '%' || row.id[1] == '9';
  return is_file ? row.text : inRoutine(row.text);
}

TEST(RapidFindings, areProvokedByTheShortestTextAndNothingElseIsFound) {
  for (const Provocation& row : provocations()) {
    const Source source = readSource(wholeFile(row), {row.dialect});
    const bool is_last = row.id == "E903";
    ASSERT_THAT(source.findings(), SizeIs(is_last ? kMostFindings + 1 : 1)) << row.id << ' ' << row.text;
    const Finding& finding = source.findings().back();
    const Place place = source.placeOf(finding.span.begin);
    EXPECT_EQ(finding.id, row.id) << row.text;
    EXPECT_EQ(finding.text, row.message);
    EXPECT_EQ(place.line, row.line) << row.id << ' ' << row.text;
    EXPECT_EQ(place.column, row.column) << row.id << ' ' << row.text;
    EXPECT_GE(finding.span.end, finding.span.begin);
  }
}

TEST(RapidFindings, haveAProvocationForEachKind) {
  for (const FindingKind& kind : kReadingFindings) {
    const bool is_provoked = std::any_of(provocations().begin(), provocations().end(),
                                         [&](const Provocation& row) { return row.id == kind.id; });
    EXPECT_TRUE(is_provoked) << kind.id;
  }
}

TEST(RapidFindings, areOnThePage) {
  std::ifstream file(test_support::inSourceTree("doc/rapid-findings.md"));
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  for (const FindingKind& kind : kReadingFindings) {
    EXPECT_NE(page.find("| " + std::string(kind.id) + " |"), std::string::npos) << kind.id;
  }
}

TEST(RapidFindings, haveDifferentIds) {
  for (std::size_t i = 1; i < kReadingFindings.size(); ++i) {
    EXPECT_NE(kReadingFindings.at(i - 1).id, kReadingFindings.at(i).id);
  }
}

TEST(RapidFindings, areDescribedAsByACompiler) {
  const Source source = readSource(inRoutine("a:=1"));
  EXPECT_EQ(describe(source, source.findings().front(), "robot.mod"),
            "robot.mod:3:5: error E202: ';' is missing");
  const Source placeholder = readSource(inRoutine("<SMT>"));
  EXPECT_EQ(describe(placeholder, placeholder.findings().front(), "a\tb"),
            "a\\tb:3:1: warning W217: placeholder: raises ERR_EXECPHR when reached");
}

TEST(RapidFindings, breakASourceIfItsTextIsInDoubt) {
  EXPECT_TRUE(readSource(inRoutine("a:=;")).isBroken());
  EXPECT_FALSE(readSource(inRoutine("<SMT>")).isBroken());
  EXPECT_FALSE(readSource(inRoutine("TEST a DEFAULT: CASE 1: ENDTEST")).isBroken());
}

}  // namespace
}  // namespace cobot_command::rapid
