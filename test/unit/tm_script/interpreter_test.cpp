#include "cobot_command/tm_script/interpreter.h"

#include "script_session.h"
#include <gmock/gmock.h>

namespace cobot_command::tm_script {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ScriptInterpreter, computesAsTheManualsExamplesDo) {
  Session session;
  EXPECT_EQ(session.run("int var_a = 10\r\nint var_b = 3\r\nfloat var_c = var_a / var_b"), "OK");
  EXPECT_EQ(session.variable("var_c"), "float 3");
  EXPECT_EQ(session.run("var_c = var_a / 3.0"), "OK");
  EXPECT_EQ(session.variable("var_c"), "float 3.333333");
}

TEST(ScriptInterpreter, wrapsIntegersAround) {
  Session session;
  EXPECT_EQ(session.valueOf("byte", "0 - 100"), "156");
  EXPECT_EQ(session.valueOf("byte", "0 - 1"), "255");
  EXPECT_EQ(session.valueOf("byte", "255 + 1"), "0");
  EXPECT_EQ(session.valueOf("int", "-2147483648 - 1"), "2147483647");
  EXPECT_EQ(session.valueOf("int", "2147483647 + 1"), "-2147483648");
  EXPECT_EQ(session.valueOf("int", "-2147483648 / -1"), "-2147483648");
  EXPECT_EQ(session.valueOf("int", "1 << 33"), "2");
  EXPECT_EQ(session.valueOf("int", "-8 >> 1"), "-4");
  EXPECT_EQ(session.valueOf("int", "~0xF0"), "-241");
}

TEST(ScriptInterpreter, convertsAsTheManualsTableSays) {
  Session session;
  EXPECT_EQ(session.valueOf("int", "1.234"), "1");
  EXPECT_EQ(session.valueOf("int", "-1.9"), "-1");
  EXPECT_EQ(session.valueOf("int", "\"1234\""), "1234");
  EXPECT_EQ(session.valueOf("int", "\"0x89AB\""), "35243");
  EXPECT_EQ(session.valueOf("int", "(int)\"1.23\""), "1");
  EXPECT_EQ(session.valueOf("float", "(float)\"1.23\""), "1.23");
  EXPECT_EQ(session.valueOf("bool", "(bool)\"1.23\""), "True");
  EXPECT_EQ(session.valueOf("bool", "(bool)\"\""), "False");
  EXPECT_EQ(session.valueOf("string", "(string)True"), "True");
  EXPECT_EQ(session.valueOf("int[]", "(int[]){\"1.23\", \"4.56\", \"0.789\"}"), "{1,4,0}");
  EXPECT_EQ(session.valueOf("float[]", "(float[]){\"1.23\", \"4.56\", \"0.789\"}"), "{1.23,4.56,0.789}");
}

TEST(ScriptInterpreter, joinsTexts) {
  Session session;
  EXPECT_EQ(session.run("string s = \"TM5\"\r\nstring s1 = \"Hi, \" + s + \" Robot\""), "OK");
  EXPECT_EQ(session.variable("s1"), "string Hi, TM5 Robot");
  EXPECT_EQ(session.run("s1 = \"Hi, 's' Robot\""), "OK;1");
  EXPECT_EQ(session.variable("s1"), "string Hi, TM5 Robot");
  EXPECT_EQ(session.valueOf("string", "\"x: \" + 417.5 + newline"), "x: 417.5\r\n");
  EXPECT_EQ(session.valueOf("string", "ABC"), "ABC");
}

TEST(ScriptInterpreter, decidesConditionsAndStopsEarly) {
  Session session;
  EXPECT_EQ(session.valueOf("int", "1 > 2 ? 3 : 2 > 1 ? 4 : 5"), "4");
  EXPECT_EQ(session.valueOf("bool", "false && 1 / 0 > 1"), "False");
  EXPECT_EQ(session.valueOf("bool", "true || 1 / 0 > 1"), "True");
  EXPECT_EQ(session.valueOf("float", "(true ? 1 : 2.5) / 2"), "0.5");  // both branches are of one type
  EXPECT_EQ(session.valueOf("bool", "\"a\" == \"a\" && 1 == 1.0"), "True");
}

TEST(ScriptInterpreter, changesVariablesAndElements) {
  Session session;
  EXPECT_EQ(session.run("int[] a = {1,2,3}\r\nint i = 0\r\na[i++] = 10\r\na[i] += 5\r\nint j = ++i + i++"),
            "OK");
  EXPECT_EQ(session.variable("a"), "int[] {10,7,3}");
  EXPECT_EQ(session.variable("i"), "int 3");
  EXPECT_EQ(session.variable("j"), "int 4");
  EXPECT_EQ(session.run("a = {}\r\ni = j = 7\r\nstring s\r\ns += i"), "OK");
  EXPECT_EQ(session.variable("a"), "int[] {}");
  EXPECT_EQ(session.variable("i"), "int 7");
  EXPECT_EQ(session.variable("s"), "string 7");
}

TEST(ScriptInterpreter, keepsVariablesOfTheProjectWhereTheyAre) {
  Session session;
  session.project.set("var_i", Scalar(1));
  EXPECT_EQ(session.run("var_i += 41\r\nint local = var_i"), "OK");
  EXPECT_EQ(textOf(*session.project.find("var_i")), "42");
  EXPECT_EQ(session.locals.find("var_i"), nullptr);
  session.locals.clear();
  EXPECT_EQ(session.run("local = 1"), "ERROR;1");
}

TEST(ScriptInterpreter, callsTheRobotWithConvertedArguments) {
  Session session;
  session.run(
      "float[] p = "
      "{0,0,90,0,90,0}\r\nPTP(\"JPP\",p,10,200,0,false)\r\nListenSend(90,GetString(Robot[0].CoordRobot))");
  EXPECT_THAT(session.robot.calls, ElementsAre("PTP(JPP,{0,0,90,0,90,0},10,200,0,False)",
                                               "ListenSend(90,{417.5,-122.25,343.9,180,0,90})"));
}

TEST(ScriptInterpreter, readsAndWritesAttributes) {
  Session session;
  EXPECT_EQ(session.run("IO[\"ControlBox\"].DO[2] = 1\r\nIO[\"ControlBox\"].DO[2] += 2\r\n"
                        "byte b = IO[\"ControlBox\"].DO[2]\r\nPoint[\"P\" + 1].Value = {1,2,3,4,5,6}"),
            "OK");
  EXPECT_EQ(session.variable("b"), "byte 3");
  EXPECT_THAT(session.robot.calls,
              ElementsAre("ControlBox.DO = 1", "ControlBox.DO = 3", "P1.Value = {1,2,3,4,5,6}"));
}

TEST(ScriptInterpreter, leavesItemsAloneThatCannotBeWritten) {
  Session session;
  EXPECT_EQ(session.run("IO[\"ControlBox\"].DI[2] = 1"), "OK");
  EXPECT_TRUE(session.robot.calls.empty());
}

TEST(ScriptInterpreter, waitsAtTheLineOfACallAndGoesOnBehindIt) {
  Session session;
  const auto text = "int i = 1\r\ni += (i++) + WaitQueueTag(1) + (i++) + WaitQueueTag(2,500)\r\nQueueTag(3)";
  Interpreter script = session.start(text);
  EXPECT_EQ(script.run(100), Progress::Waiting);
  EXPECT_EQ(script.line(), 2);
  EXPECT_EQ(session.variable("i"), "int 1");  // what the line does comes into force at its end
  EXPECT_EQ(script.run(100), Progress::Waiting);
  script.resume(Scalar(10));
  EXPECT_EQ(script.run(100), Progress::Waiting);
  script.resume(Scalar(20));
  EXPECT_EQ(script.run(100), Progress::Done);
  EXPECT_EQ(session.variable("i"), "int 36");  // 3 + (1 + 10 + 2 + 20)
  EXPECT_THAT(session.robot.calls, ElementsAre("WaitQueueTag(1)", "WaitQueueTag(2,500)", "QueueTag(3)"));
}

TEST(ScriptInterpreter, asksAndWritesNothingTwiceAfterAWait) {
  Session session;
  Interpreter script =
      session.start("float f = Robot[0].CoordRobot[0] + (IO[\"ControlBox\"].DO[0] = 1) + WaitQueueTag(1)");
  EXPECT_EQ(script.run(1), Progress::Waiting);
  const int reads = session.robot.reads;
  script.resume(Scalar(1));
  EXPECT_EQ(script.run(1), Progress::Done);
  EXPECT_EQ(session.robot.reads, reads);
  EXPECT_THAT(session.robot.calls, ElementsAre("ControlBox.DO = 1", "WaitQueueTag(1)"));
  EXPECT_EQ(session.variable("f"), "float 419.5");
}

TEST(ScriptInterpreter, endsWhereTheRobotEndsIt) {
  Session session;
  EXPECT_EQ(session.run("ScriptExit()\r\nQueueTag(1)"), "OK");
  EXPECT_THAT(session.robot.calls, ElementsAre("ScriptExit()"));
}

TEST(ScriptInterpreter, runsAsManyStatementsAsItIsTold) {
  Session session;
  Interpreter script = session.start("int i = 1\r\n\r\ni++\r\ni++");
  EXPECT_EQ(script.run(2), Progress::Ready);
  EXPECT_EQ(session.variable("i"), "int 2");
  EXPECT_EQ(script.line(), 4);
  EXPECT_EQ(script.run(2), Progress::Done);
  EXPECT_EQ(script.line(), 0);
}

TEST(ScriptInterpreter, namesLineAndReasonOfAFailureAndRunsNothingBehindIt) {
  Session session;
  EXPECT_EQ(session.run("int i = 0\r\ni = 1 / i\r\nQueueTag(1)"), "line 2: division by zero");
  EXPECT_TRUE(session.robot.calls.empty());
  EXPECT_EQ(session.run("int[] a = {1}\r\na[i + 1] = 2"), "line 2: index 1 is outside of an array of 1");
  EXPECT_EQ(session.run("ChangeLoad(50)"), "line 1: ChangeLoad: the load is too heavy");
  EXPECT_EQ(session.run("i = \"abc\""), "line 1: \"abc\" is no number");
  EXPECT_THAT(session.run("i = 1e20"), HasSubstr("no number that an int holds"));
  EXPECT_THAT(session.run("float[] p = {1}\r\nChangeBase(p)"), HasSubstr("6 elements are expected, not 1"));
  EXPECT_EQ(session.variable("i"), "int 0");
}

TEST(ScriptInterpreter, boundsWhatAScriptCanStore) {
  Session session;
  std::string doubling = "string s = \"x\"";
  for (int i = 0; i < 40; ++i) doubling += "\r\ns += s";
  EXPECT_THAT(session.run(doubling), HasSubstr("a text of more than 65536 bytes"));
  session.locals.clear();
  std::string growing = "int[] a = {1}";
  for (int i = 0; i < 12; ++i) growing += "\r\na = Array_Append(a, a)";
  EXPECT_THAT(session.run(growing), HasSubstr("an array of more than 2048 elements"));
  session.locals.clear();
  std::string many = "string s = String_Replace(\"" + std::string(1000, 'a') + "\", \"a\", \"" +
                     std::string(64, 'b') + "\")";
  for (int i = 0; i < 300; ++i) many += "\r\nstring s" + std::to_string(i) + " = s";
  EXPECT_THAT(session.run(many), HasSubstr("no room for more variables"));
}

TEST(ScriptInterpreter, boundsWhatALineCanTake) {
  Session session;
  ASSERT_EQ(session.run("string s = String_Replace(\"" + std::string(1000, 'a') + "\", \"a\", \"" +
                        std::string(64, 'b') + "\")"),
            "OK");
  std::string line = "bool same = s == s";
  for (int i = 0; i < 20000; ++i) line += " && s == s";
  EXPECT_EQ(session.run(line), "line 1: the line takes too much work");
}

}  // namespace
}  // namespace cobot_command::tm_script
