#include "cobot_command/tm_script/checker.h"

#include "script_session.h"
#include <gmock/gmock.h>

namespace cobot_command::tm_script {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string replyTo(std::string_view text) {
  return replyOf(Session().check(text));
}

std::string errorOf(std::string_view text, Version tmflow = {1, 80}) {
  const Findings findings = Session(tmflow).check(text);
  return findings.errors.empty() ? "" : findings.errors.front().reason;
}

TEST(ScriptChecker, namesTheLinesOfErrorsAsTheControllerDoes) {
  EXPECT_EQ(replyTo("int var_i = 100\r\nvar_i = 1000\r\nvar_i++"), "OK");
  EXPECT_EQ(replyTo("int i = \"x\" * 2\r\nint j = 2\r\nj = = 3"), "ERROR;1;3");
  EXPECT_EQ(replyTo(""), "OK");
}

TEST(ScriptChecker, namesTheLinesOfWarningsUnlessThereAreErrors) {
  EXPECT_EQ(replyTo("int a = 1\r\nint i = 1.234\r\nbyte b = 1000"), "OK;2;3");
  EXPECT_EQ(replyTo("int i = 1.234\r\nnothing()"), "ERROR;2");
}

// I848-E-03 1.6.
TEST(ScriptChecker, warnsWhereTheManualWarns) {
  EXPECT_EQ(replyTo("int i = 1.234"), "OK;1");
  EXPECT_EQ(replyTo("int i = \"1234\""), "OK;1");
  EXPECT_EQ(replyTo("string s = 1234"), "OK;1");
  EXPECT_EQ(replyTo("string s = ABC"), "OK;1");
  EXPECT_EQ(replyTo("ChangeBase(RobotBase)"), "OK;1");
  EXPECT_EQ(replyTo("string s = \"TM5\"\r\nstring s1 = \"Hi, 's' Robot\""), "OK;2");
  EXPECT_EQ(replyTo("string s1 = \"It's Joe's\""), "OK");
  EXPECT_EQ(replyTo("int i = 5\r\ni += 1.5"), "OK;2");
}

TEST(ScriptChecker, doesNotWarnWhereNothingIsLost) {
  EXPECT_EQ(replyTo("byte b = 255\r\nb += 1\r\nfloat f = b\r\ndouble d = f\r\nf = d"), "OK");
  EXPECT_EQ(replyTo("float[] p = {0,0,90,0,90,0}\r\nPTP(\"JPP\",p,10,200,0,false)"), "OK");
  EXPECT_EQ(replyTo("PTP(\"CPP\",417.50000,-122.30000,343.90000,180.00000,0.00000,90.00000,10,200,0,true)"),
            "OK");
  EXPECT_EQ(replyTo("string s = \"a\"\r\ns += 1\r\ns = s + 2.5 + true"), "OK");
  EXPECT_EQ(replyTo("string[] s = {}"), "OK");
}

TEST(ScriptChecker, knowsAVariableFromTheLineBehindItsDeclaration) {
  EXPECT_EQ(replyTo("int i = i + 1"), "ERROR;1");
  EXPECT_EQ(replyTo("i = 1\r\nint i"), "ERROR;1");
  EXPECT_EQ(replyTo("int i\r\nint i = 2"), "ERROR;2");
  EXPECT_EQ(errorOf("int i\r\nfloat i"), "there is a variable i already");
}

TEST(ScriptChecker, remembersVariablesOfEarlierScriptsAndOfTheProject) {
  Session session;
  session.project.set("var_speed", Scalar(10));
  EXPECT_EQ(session.run("int var_i = 100"), "OK");
  EXPECT_EQ(session.run("int var_i = 100"), "ERROR;1");  // the manual's own case: $TMSCT,9,4,ERROR;1,*02
  EXPECT_EQ(session.run("int var_speed"), "ERROR;1");
  EXPECT_EQ(session.run("var_i = var_speed"), "OK");
}

TEST(ScriptChecker, findsArgumentsThatNoFormTakes) {
  EXPECT_THAT(errorOf("PTP(\"JPP\",1,2,3)"),
              HasSubstr("PTP(string, byte, byte, byte) is not defined, only PTP("));
  EXPECT_THAT(errorOf("ChangeBase({1,2,3})"), HasSubstr("6 elements are expected, not 3"));
  EXPECT_EQ(replyTo("PTP(\"CPP\",{1,2,3,4,5,6},10,200,0,false,{0,2,4})"), "OK");
  EXPECT_EQ(replyTo("PTP(\"JPP\",{1,2,3,4,5,6},10,200,0,0)"), "ERROR;1");
  EXPECT_EQ(replyTo("QueueTag()"), "ERROR;1");
  EXPECT_EQ(replyTo("QueueTag(1)\r\nQueueTag(1,1)\r\nQueueTag(1,1,1)"), "ERROR;3");
}

TEST(ScriptChecker, findsFunctionsThatAVersionDoesNotHave) {
  EXPECT_EQ(errorOf("QueueTag(1)", {1, 72}), "QueueTag exists since TMflow 1.76; this is 1.72");
  EXPECT_EQ(errorOf("QueueTag(1)", {1, 76}), "");
  EXPECT_THAT(errorOf("StopAndClearBuffer(1)", {1, 80}), HasSubstr("not defined"));
  EXPECT_THAT(errorOf("StopAndClearBuffer(1)", {1, 80}), EndsWith("only StopAndClearBuffer()"));
  EXPECT_EQ(errorOf("StopAndClearBuffer(1)", {1, 82}), "");
  EXPECT_THAT(errorOf("float[] f = points2coord({0,0,0,0,0,0},{1,0,0,0,0,0},{0,1,0,0,0,0})"),
              HasSubstr("1.82"));
}

TEST(ScriptChecker, tellsKnownFunctionsFromUnknownOnes) {
  EXPECT_EQ(errorOf("File_WriteText(\"a\", \"b\")"), "File_WriteText is a known function, but not simulated");
  EXPECT_EQ(errorOf("int i = random(1, 6)"), "random is a known function, but not simulated");
  EXPECT_THAT(errorOf("Sleep(100)"), HasSubstr("programs of TMflow 2"));
  EXPECT_EQ(errorOf("Jump(3)"), "there is no function Jump");
}

TEST(ScriptChecker, demandsLiteralsWhereTheManualDoes) {
  EXPECT_THAT(errorOf("int st = 1\r\nStopAndClearBuffer(st)", {1, 82}),
              HasSubstr("must be written as a literal"));
}

TEST(ScriptChecker, looksItemsUpBeforeTheScriptRuns) {
  EXPECT_EQ(replyTo("IO[\"ControlBox\"].DO[2]=1"), "OK");
  EXPECT_EQ(replyTo("IO[\"ControlBox\"].DO[16]=1"), "ERROR;1");
  EXPECT_EQ(errorOf("byte b = IO[\"Nowhere\"].DI[0]"), "there is no Nowhere");
  EXPECT_EQ(errorOf("float f = Robot[0].Height"), "there is no Robot.Height");
  EXPECT_EQ(replyTo("Point[\"P1\"].Value = {1,2,3}"), "ERROR;1");
  EXPECT_EQ(replyTo("IO[1.5].DO[2] = 1"), "ERROR;1");
}

TEST(ScriptChecker, takesANameWithoutQuotesInBracketsWithAWarning) {
  EXPECT_EQ(replyTo("IO[ControlBox].DO[2]=1"), "OK;1");
  EXPECT_EQ(replyTo("byte b = IO[ControlBox].DI[0]"), "OK;1");
  EXPECT_EQ(replyTo("string ControlBox = \"ControlBox\"\r\nIO[ControlBox].DO[2]=1"), "OK");
  EXPECT_EQ(errorOf("IO[Nowhere].DO[2]=1"), "there is no Nowhere");
  EXPECT_EQ(replyTo("float[] f = {1}\r\nf[here] = 2"), "ERROR;2");
  EXPECT_EQ(Session().check("IO[ControlBox].DO[2]=1").warnings.size(), 1U);
}

TEST(ScriptChecker, findsOperandsOfWrongTypes) {
  for (const char* value : {"true + 1", "1 && true", "\"a\" * 2", "{1} + {2}", "1.5 | 2", "!1", "~1.5",
                            "-\"a\"", "true < false", "\"a\" == 1", "1 ? 2 : 3", "true ? 1 : \"a\"",
                            "{1, \"a\"}", "{{1}}", "(int)true", "(bool)1", "({1})[1.5]", "5[0]", "missing"}) {
    EXPECT_EQ(replyTo(std::string("int i = ") + value), "ERROR;1") << value;
  }
}

TEST(ScriptChecker, findsWhatCannotBeChangedAndLinesThatDoNothing) {
  for (const char* line :
       {"5 = 3", "abs(1) = 3", "(a + 1) = 2", "5++", "f++", "1 + 2", "a", "-a", "++a = 1"}) {
    EXPECT_EQ(replyTo(std::string("int a\r\nfloat f\r\n") + line), "ERROR;3") << line;
  }
}

TEST(ScriptChecker, looksAtEachPartOnce) {
  std::string key = "\"ControlBox\"";
  for (int i = 0; i < 30; ++i) key = "IO[" + key + "].DO[0]";
  EXPECT_EQ(replyTo("byte b = " + key), "OK");  // would never end if the work doubled with each level
  std::string call = "1";
  for (int i = 0; i < 60; ++i) call = "abs(" + call + ')';
  EXPECT_EQ(replyTo("int i = " + call), "OK");
}

TEST(ScriptChecker, changesNothing) {
  Session session;
  EXPECT_THAT(session.check("int i = 1\r\nPTP(\"JPP\",1,2,3,4,5,6,10,200,0,false)").errors, IsEmpty());
  EXPECT_EQ(session.variable("i"), "none");
  EXPECT_THAT(session.robot.calls, IsEmpty());
}

}  // namespace
}  // namespace cobot_command::tm_script
