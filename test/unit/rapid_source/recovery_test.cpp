// Every finding of a file in one pass, and no echoes (section 3 of the contract of RAPID).
#include "tree_text.h"
#include <gmock/gmock.h>

namespace cobot_command::rapid {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> inP(const std::string& lines) {
  return findingsOf(inRoutine(lines));
}

TEST(RapidRecovery, continuesAfterTheNextSemicolon) {
  EXPECT_THAT(inP("a:=; b:=]; c:=1;\nd:=+;"), ElementsAre("E201 3:4", "E201 3:9", "E201 4:5"));
}

TEST(RapidRecovery, continuesBeforeAWordAtTheStartOfALine) {
  EXPECT_THAT(inP("a:=(1\nIF b THEN\nc:=;\nENDIF"), ElementsAre("E201 4:1", "E201 5:4"));
}

TEST(RapidRecovery, skipsNothingForAMissingSemicolon) {
  EXPECT_THAT(inP("a:=1\nb:=2\ngo\nGOTO x\nc:=3"),
              ElementsAre("E202 3:5", "E202 4:5", "E202 5:3", "E202 6:7", "E202 7:5"));
  EXPECT_THAT(inP("go ! comment\n\nb:=1;"), ElementsAre("E202 3:3"));
  EXPECT_THAT(inP("RETURN\nb:=1;"), ElementsAre("E202 3:7"));
}

TEST(RapidRecovery, takesMissingThenDoAndColonAtTheEndOfALineAsWritten) {
  EXPECT_THAT(inP("WHILE a\nb;\nENDWHILE"), ElementsAre("E201 4:1"));
  EXPECT_THAT(inP("FOR i FROM 1 TO 2\nb;\nENDFOR"), ElementsAre("E201 4:1"));
  EXPECT_THAT(inP("IF a THEN\nb;\nELSEIF c\nd;\nENDIF"), ElementsAre("E201 6:1"));
  EXPECT_THAT(inP("IF a\nENDIF"), ElementsAre("E201 4:1"));
  EXPECT_THAT(inP("TEST a\nCASE 1\nb;\nENDTEST"), ElementsAre("E201 5:1"));
}

TEST(RapidRecovery, keepsTheBlockOfAHeaderWithAnError) {
  EXPECT_THAT(inP("IF a+ THEN\nb;\nELSE\nc;\nENDIF"), ElementsAre("E201 3:7"));
  EXPECT_THAT(inP("WHILE ] DO\nb;\nENDWHILE"), ElementsAre("E201 3:7"));
  EXPECT_THAT(inP("FOR 3 FROM 1 TO 2 DO\nb;\nENDFOR"), ElementsAre("E201 3:5"));
  EXPECT_THAT(inP("TEST a\nCASE +:\nb;\nCASE 2:\nENDTEST"), ElementsAre("E201 4:7"));
  EXPECT_THAT(inP("IF a+) b;\nc:=;"), ElementsAre("E201 3:6", "E201 4:4"));
}

TEST(RapidRecovery, blamesTheOpeningWordOfABlockThatIsNotClosed) {
  EXPECT_THAT(inP("WHILE a DO\nIF b THEN\nc;\nENDWHILE\nd;"), ElementsAre("E203 4:1"));
  EXPECT_THAT(inP("IF a THEN\nb;\nERROR\nc;"), ElementsAre("E203 3:1"));
  EXPECT_THAT(findingsOf("MODULE m\nPROC p()\na;\nPROC q()\nENDPROC\nENDMODULE"), ElementsAre("E203 2:1"));
  EXPECT_THAT(findingsOf("MODULE m\nPROC p()\na;\nLOCAL PROC q()\nENDPROC\nENDMODULE"),
              ElementsAre("E203 2:1"));
  EXPECT_THAT(findingsOf("MODULE m\nPROC p()\na;"), ElementsAre("E203 1:1", "E203 2:1"));
}

TEST(RapidRecovery, reportsAStrayEndOnceAndContinues) {
  EXPECT_THAT(inP("a;\nENDWHILE\nb:=;"), ElementsAre("E204 4:1", "E201 5:4"));
  EXPECT_THAT(inP("IF a THEN\nENDFOR\nENDIF"), ElementsAre("E204 4:1"));
  EXPECT_THAT(inP("CASE 1,2:\nELSEIF a THEN\nDEFAULT:\nb:=;"),
              ElementsAre("E204 3:1", "E204 4:1", "E204 5:1", "E201 6:4"));
}

TEST(RapidRecovery, reportsNoSyntaxErrorAtOrAfterALexicalOne) {
  EXPECT_THAT(inP("a:=1 $ 2;"), ElementsAre("E101 3:6"));
  EXPECT_THAT(inP("VAR num 3x:=1;"), ElementsAre("E106 3:9"));
  EXPECT_THAT(inP("s:=\"open;\nb:=;"), ElementsAre("E103 3:4", "E201 4:4"));
  EXPECT_THAT(inP("VAR num for 3 4;"), ElementsAre("E109 3:9"));
}

TEST(RapidRecovery, reportsASyntaxErrorBeforeALexicalOne) {
  EXPECT_THAT(inP("a:=; b:=1$;"), ElementsAre("E201 3:4", "E101 3:10"));
}

TEST(RapidRecovery, readsAroundUnknownCharacters) {
  EXPECT_THAT(inP("IF a $ THEN\nb;\nENDIF"), ElementsAre("E101 3:6"));
  EXPECT_THAT(inP("f $ a, \xE2\x82\xAC b;"), ElementsAre("E101 3:3", "E101 3:8"));
}

TEST(RapidRecovery, takesAReservedWordAtTheStartOfALineForNoName) {
  EXPECT_THAT(findingsOf("MODULE m\nVAR num\nPROC p()\nENDPROC\nENDMODULE"), ElementsAre("E201 3:1"));
}

TEST(RapidRecovery, declaresWhatHasAName) {
  EXPECT_EQ(instructionText("VAR num a:=;"), "!Data VAR a(TypeName num)");
  EXPECT_EQ(instructionText("VAR num a{]:=1;"), "!Data VAR a(TypeName num, Dimensions)");
  EXPECT_EQ(instructionText("VAR num a=1;"), "!Data VAR a(TypeName num, Number 1)");
}

TEST(RapidRecovery, readsTheBodyAfterAFaultyHeaderOfARoutine) {
  EXPECT_THAT(findingsOf("MODULE m\nPROC p(num a\nb:=;\nENDPROC\nENDMODULE"),
              ElementsAre("E201 3:1", "E201 3:4"));
  EXPECT_THAT(findingsOf("MODULE m\nPROC p\nb:=;\nENDPROC\nENDMODULE"), ElementsAre("E201 3:1", "E201 3:4"));
  EXPECT_THAT(findingsOf("MODULE m\nPROC p(num,\\x) y\nb:=;\nENDPROC\nENDMODULE"),
              ElementsAre("E201 2:11", "E201 3:4"));
  EXPECT_THAT(findingsOf("MODULE m\nFUNC f()\nRETURN 1;\nENDFUNC\nENDMODULE"), ElementsAre("E201 2:7"));
}

TEST(RapidRecovery, marksInstructionsWhoseMeaningIsInDoubt) {
  EXPECT_EQ(instructionText("a=1;"), "!Assignment(Reference a, Number 1)");
  EXPECT_EQ(instructionText("a:=\"\\zz\";"), "Assignment(Reference a, String \"\\zz\")");
  EXPECT_EQ(instructionText("a:=1E39;"), "Assignment(Reference a, Number 1E39)");
  EXPECT_EQ(instructionText("a:=1x;"), "!Assignment(Reference a, Number 1x)");
  EXPECT_EQ(instructionText("a:=$1;"), "!Assignment(Reference a, Number 1)");
  EXPECT_EQ(instructionText("VAR num " + std::string(33, 'a') + ";"),
            "Data VAR " + std::string(33, 'a') + "(TypeName num)");
}

TEST(RapidRecovery, marksOnlyTheHeaderOfABlockOrWhatIsInIt) {
  EXPECT_EQ(instructionText("IF a THEN\nb=1;\nENDIF"),
            "If(Reference a, List(!Assignment(Reference b, Number 1)))");
  EXPECT_EQ(instructionText("IF a$ THEN\nb:=1;\nENDIF"),
            "!If(Reference a, List(Assignment(Reference b, Number 1)))");
  EXPECT_EQ(instructionText("IF a THEN\nb:=1;"), "If(Reference a, List(Assignment(Reference b, Number 1)))");
}

TEST(RapidRecovery, keepsTextWithoutMeaningAsOneNode) {
  EXPECT_EQ(instructionText("] ) 3;\n4;"), "!Unread");
  const Source source = readSource(inRoutine("] ) 3;\n4;\na;"));
  EXPECT_EQ(treeText(source, bodyOf(source)), "List(!Unread, Call a)");
}

TEST(RapidRecovery, skipsARoutineThatIsNestedTooDeep) {
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "IF a THEN\n";
  EXPECT_THAT(findingsOf("MODULE m\nPROC p()\n" + deep + "ENDPROC\nPROC q()\na:=;\nENDPROC\nENDMODULE"),
              ElementsAre("E219 203:1", "E201 305:4"));
}

TEST(RapidRecovery, reportsFindingsInTheOrderOfTheText) {
  EXPECT_THAT(inP("f(,);"), ElementsAre("E220 3:2", "E218 3:3"));
}

TEST(RapidRecovery, findsNothingInAnEmptyFile) {
  EXPECT_THAT(findingsOf(""), IsEmpty());
  EXPECT_THAT(findingsOf("! only a comment"), IsEmpty());
}

}  // namespace
}  // namespace cobot_command::rapid
