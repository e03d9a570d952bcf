// Long and hostile programs: linear time, by counting what is looked at, and bounded memory.
#include "cobot_command/rapid/source/limits.h"

#include "../rapid_source/tree_text.h"
#include "checked_text.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// How often each node of the tree is looked at, on average.
double stepsPerNode(const CheckedProgram& checked) {
  const std::size_t nodes = checked.draft->source(kPredefinedFiles).tree().size();
  return static_cast<double>(checked.steps) / static_cast<double>(nodes);
}

constexpr double kMostSteps = 3;
constexpr int kMany = 30000;

/// `line` repeated; {i} and {next} become the number of the line, and of the next one.
std::string numbered(int times, const std::string& line) {
  std::string text;
  for (int i = 0; i < times; ++i) {
    text += fmt::format(fmt::runtime(line), fmt::arg("i", i), fmt::arg("next", i + 1));
  }
  return text;
}

TEST(RapidCheckLimits, checksALongModuleInLinearTime) {
  const CheckedProgram checked = checkedText(withMain(repeated(
      kMany, "MoveL [[1,-2,3E2],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100\\T:=5,z50,tool0;\n")));
  EXPECT_THAT(checked.findings.front(), IsEmpty());
  EXPECT_LT(stepsPerNode(checked), kMostSteps);
}

TEST(RapidCheckLimits, resolvesLongChainsOfDeclarationsInAnyOrder) {
  const std::string constants =
      numbered(kMany, "CONST num c{i}:=c{next}+1;\n") + fmt::format("CONST num c{}:=1;\n", kMany);
  const CheckedProgram checked = checkedText(withMain("reg1:=c0;", constants));
  EXPECT_THAT(checked.findings.front(), IsEmpty());
  EXPECT_LT(stepsPerNode(checked), kMostSteps);
  const std::string aliases =
      numbered(kMany, "ALIAS a{next} a{i};\n") + fmt::format("ALIAS num a{};\n", kMany);
  EXPECT_THAT(checkedText(withMain("", aliases + "VAR a0 x;\n")).findings.front(), IsEmpty());
}

TEST(RapidCheckLimits, reportsCirclesOfDeclarationsOnce) {
  const std::string circle = numbered(1000, "CONST num c{i}:=c{next};\n") + "CONST num c1000:=c0;\n";
  EXPECT_THAT(findingsInMain("", circle), ElementsAre("E307 1002:18"));
  const std::string records =
      numbered(1000, "RECORD r{i} r{next} x; ENDRECORD\n") + "RECORD r1000 r0 x; ENDRECORD\n";
  EXPECT_THAT(findingsInMain("", records), ElementsAre("E316 1002:14"));
}

TEST(RapidCheckLimits, knowsTheSizeOfRecordsInRecords) {
  const std::string records =
      "RECORD r0 num x; ENDRECORD\n" + numbered(100, "RECORD r{next} r{i} x; r{i} y; ENDRECORD\n");
  EXPECT_THAT(findingsInMain("", records), Contains("E326 27:8"));
}

TEST(RapidCheckLimits, boundTheMemoryOfConstants) {
  const std::string data = "CONST num big{1000000}:=" + std::string("[1];\n");
  EXPECT_THAT(findingsInMain("", data), ElementsAre("E407 2:25"));
  const std::string texts = "CONST string s{1000}:=[" + repeated(999, "\"\",") + "\"\"];\n";
  const std::string copies = numbered(1000, "CONST string s{i}{{1000}}:=s;\n");
  EXPECT_THAT(findingsInMain("", texts + copies), ElementsAre("E326 799:14"));
}

TEST(RapidCheckLimits, checksHostileProgramsInLinearTime) {
  const std::string labels = numbered(kMany, "l{i}:\n") + numbered(kMany, "IF reg1=1 GOTO l{i};\n");
  const std::string values = "TEST reg1\n" + numbered(kMany, "CASE {i}:\n") + "ENDTEST\n";
  const std::string unknown = numbered(kMany, "reg1:=unknown{i};\n");
  const std::string loops = repeated(kMany, "FOR i FROM 1 TO 2 DO ENDFOR\n");
  const std::string chain = "reg1:=1" + repeated(kMany, "+1") + ";";
  const std::string aggregate = "reg1:=[" + repeated(kMany, "[1],") + "1];";
  for (const std::string& lines : {labels, values, unknown, loops, chain, aggregate}) {
    const CheckedProgram checked = checkedText(withMain(lines));
    EXPECT_LT(stepsPerNode(checked), kMostSteps) << lines.substr(0, 30);
    EXPECT_LE(checked.findings.front().size(), kMostFindings + 1);
  }
}

TEST(RapidCheckLimits, checksManyDeclarationsInLinearTime) {
  const std::string data = numbered(kMany, "VAR num v{i}:={i};\n");
  const std::string twice = repeated(kMany, "VAR num same;\n");
  const std::string components =
      "RECORD wide\n" + numbered(kMany, "num x{i};\n") + "ENDRECORD\nVAR wide w;\n";
  for (const std::string& declarations : {data, twice, components}) {
    const CheckedProgram checked = checkedText(withMain(repeated(1000, "reg1:=reg1+1;\n"), declarations));
    EXPECT_LT(stepsPerNode(checked), kMostSteps) << declarations.substr(0, 30);
  }
  EXPECT_THAT(findingsInMain(numbered(kMany, "w.x{i}:=1;\n"), components), IsEmpty());
}

TEST(RapidCheckLimits, checksCallsOfARoutineWithManyParameters) {
  std::string parameters;
  std::string arguments;
  for (int i = 0; i < kMany; ++i) {
    parameters += fmt::format("\\num p{}", i);
    arguments += fmt::format("\\p{}:=0", i);
  }
  const CheckedProgram checked = checkedText("MODULE m PROC main() q " + arguments + "; ENDPROC PROC q(" +
                                             parameters + ") ENDPROC ENDMODULE");
  EXPECT_THAT(checked.findings.front(), IsEmpty());
  EXPECT_LT(stepsPerNode(checked), kMostSteps);
}

TEST(RapidCheckLimits, followsTheDeepestNesting) {
  const std::string brackets = "reg1:=" + repeated(200, "(") + "1" + repeated(200, ")") + ";\n";
  const std::string blocks = repeated(200, "WHILE reg1=1 DO\n") + repeated(200, "ENDWHILE\n");
  const std::string compact = repeated(199, "IF reg1=1 ") + "reg1:=2;\n";
  const std::string calls = "reg1:=" + repeated(200, "Abs(") + "1" + repeated(200, ")") + ";\n";
  EXPECT_THAT(findingsInMain(brackets + blocks + compact + calls), IsEmpty());
}

TEST(RapidCheckLimits, reportAtMostAHundredFindingsOfEachFile) {
  const auto all = findingsInMain(repeated(5000, "a:=1;\n"));
  ASSERT_THAT(all, SizeIs(kMostFindings + 1));
  EXPECT_EQ(all.front(), "E401 3:1");
  EXPECT_EQ(all.back(), "E903 103:1");
  // Those of reading count, too.
  const auto mixed = findingsInMain(repeated(60, "a:=;\n") + repeated(60, "a:=1;\n"));
  ASSERT_THAT(mixed, SizeIs(kMostFindings + 1));
  EXPECT_EQ(mixed.front(), "E201 3:4");
  EXPECT_EQ(mixed.back(), "E903 103:1");
}

}  // namespace
}  // namespace cobot_command::rapid
