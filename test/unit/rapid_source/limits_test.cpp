// Long and deeply nested texts: linear time, by counting the tokens that the parser looks at, and bounded
// memory.
#include "cobot_command/rapid/source/limits.h"

#include "tree_text.h"
#include <gmock/gmock.h>

#include "cobot_command/rapid/source/printer.h"
#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// How often the parser looks at each token, on average.
double stepsPerToken(const Source& source) {
  return static_cast<double>(source.steps()) / static_cast<double>(source.tokens().size());
}

constexpr double kMostSteps = 4;

TEST(RapidLimits, readsALongModuleInLinearTime) {
  const Source source =
      readSource(inRoutine(repeated(30000, "MoveL [[1,-2,3E2],[1,0,0,0]],v100\\T:=5,z50,tool0;\n")));
  EXPECT_THAT(source.findings(), IsEmpty());
  EXPECT_LT(stepsPerToken(source), kMostSteps);
}

/// Texts that could make a parser look at the rest of the file again and again.
TEST(RapidLimits, readsHostileTextsInLinearTime) {
  for (const std::string unit : {"f(\n",        "IF a f(\n",
                                 "IF a f( ",    "a:=(\n",
                                 "a:=[\n",      "a{",
                                 "f \\a:=",     "IF ",
                                 "IF a THEN\n", "ENDIF\n",
                                 "ELSEIF (",    "CASE 1,",
                                 "TEST a\n",    "FOR i FROM ",
                                 "WHILE a\n",   "%%%",
                                 "%\"a\" ",     "<SMT>",
                                 "\"",          "!\n",
                                 "$\n",         "VAR num for for ",
                                 "VAR num a{",  "PROC p(",
                                 "PROC p()\n",  "ERROR\n",
                                 "RECORD r ",   "LOCAL ",
                                 "MODULE m\n",  "a!\n",
                                 "f!\n(!\n",    "- ",
                                 "NOT ",        "1+",
                                 "a.b",         "x:=y:=",
                                 ";",           "CONNECT ",
                                 "\\",          "f(a,b",
                                 "RETURN\n"}) {
    const Source in_routine = readSource(inRoutine(repeated(20000, unit)));
    EXPECT_LT(stepsPerToken(in_routine), kMostSteps) << unit;
    EXPECT_LE(in_routine.findings().size(), kMostFindings + 1) << unit;
    const Source alone = readSource("MODULE m\n" + repeated(20000, unit));
    EXPECT_LT(stepsPerToken(alone), kMostSteps) << unit;
  }
}

TEST(RapidLimits, makesNodesInProportionToTheTokens) {
  const Source chain = readSource(inRoutine("a:=1" + repeated(100000, "+1") + ";"));
  EXPECT_THAT(chain.findings(), IsEmpty());
  EXPECT_LT(chain.tree().size(), 2 * chain.tokens().size());
}

TEST(RapidLimits, nestsTwoHundredLevelsAndNoMore) {
  const auto nested = [](std::size_t depth) {
    return findingsOf(inRoutine("a:=" + repeated(depth, "[") + "1" + repeated(depth, "]") + ";"));
  };
  EXPECT_THAT(nested(200), IsEmpty());
  EXPECT_THAT(nested(201), SizeIs(1));
  EXPECT_THAT(nested(100000), SizeIs(1));
  for (const std::string opening : {"(", "f(", "a{", "-", "f(\\x:=", "[-(f(a{"}) {
    EXPECT_THAT(findingsOf(inRoutine("a:=" + repeated(100000, opening) + "1;")), SizeIs(1)) << opening;
  }
}

TEST(RapidLimits, nestsTwoHundredBlocks) {
  EXPECT_THAT(findingsOf(inRoutine(repeated(200, "WHILE a DO\n") + repeated(200, "ENDWHILE\n"))), IsEmpty());
  EXPECT_THAT(findingsOf(inRoutine(repeated(100000, "IF a "))), SizeIs(1));
}

TEST(RapidLimits, readsLongChainsOfBranches) {
  EXPECT_THAT(findingsOf(inRoutine("IF a THEN\n" + repeated(30000, "ELSEIF b THEN\nc;\n") + "ENDIF")),
              IsEmpty());
  EXPECT_THAT(findingsOf(inRoutine("TEST a\n" + repeated(30000, "CASE 1:\nc;\n") + "ENDTEST")), IsEmpty());
}

TEST(RapidLimits, reportsAtMostAHundredFindingsAndThatThereAreMore) {
  const auto all = findingsOf(inRoutine(repeated(5000, "a:=;\n")));
  ASSERT_THAT(all, SizeIs(kMostFindings + 1));
  EXPECT_EQ(all.front(), "E201 3:4");
  EXPECT_EQ(all[kMostFindings - 1], "E201 102:4");
  EXPECT_EQ(all.back(), "E903 103:4");
  EXPECT_THAT(findingsOf(inRoutine(repeated(kMostFindings, "a:=;\n"))), SizeIs(kMostFindings));
}

TEST(RapidLimits, keepsTheFirstFindingsOfTheTextNotOfTheSearch) {
  // The end of the module is missing: found last, and first in the text.
  const auto all = findingsOf("MODULE m\nPROC p()\n" + repeated(3000, "a:=$;\n"));
  ASSERT_THAT(all, SizeIs(kMostFindings + 1));
  EXPECT_EQ(all[0], "E203 1:1");
  EXPECT_EQ(all[1], "E203 2:1");
  EXPECT_EQ(all[2], "E101 3:4");
}

TEST(RapidLimits, printsLongTexts) {
  const Source source = readSource(inRoutine(repeated(30000, "! comment\nif a then b:=-1; endif\n")));
  const std::string once = print(source, predefinedNames());
  EXPECT_EQ(print(readSource(once), predefinedNames()), once);
}

TEST(RapidLimits, printsCallsOfARoutineWithManyParameters) {
  std::string parameters = "num p0";
  std::string arguments = "P0:=0";
  for (int i = 1; i < 20000; ++i) {
    parameters += ",num p" + std::to_string(i);
    arguments += ",P" + std::to_string(i) + ":=0";
  }
  const Source source =
      readSource(inRoutine("q " + arguments + ";", "PROC q(" + parameters + ")\nENDPROC\n"));
  EXPECT_THAT(source.findings(), IsEmpty());
  const std::string once = print(source, predefinedNames());
  EXPECT_NE(once.find("p0:=0,p1:=0"), std::string::npos);
  EXPECT_EQ(print(readSource(once), predefinedNames()), once);
}

}  // namespace
}  // namespace cobot_command::rapid
