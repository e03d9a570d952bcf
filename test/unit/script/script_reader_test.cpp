// What a script means before it is sent: the language as the controller reads it, and what is not known
// without one.

#include "cobot_command/script/script_reader.h"

#include "test_names.h"
#include <gmock/gmock.h>

namespace cobot_command::script {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> textsOf(std::string_view script) {
  const auto read = readScript(script);
  EXPECT_TRUE(read) << script << ": line " << read.error().front().line << ", "
                    << read.error().front().reason;
  std::vector<std::string> texts;
  if (!read) return texts;
  for (const auto& [line, command] : *read) texts.push_back(toText(command));
  return texts;
}

TEST(ScriptReader, takesVariablesExpressionsAndComments) {
  EXPECT_THAT(textsOf("float[] home = {0,0,90,0,90,0}  // where it rests\n"
                      "int speed = 20\n"
                      "speed += 15\n"
                      "/* home[0] = 99 */\n"
                      "home[0] = -home[2] / 2\n"
                      "PTP(\"JPP\", home, speed, 200, 0, false)"),
              ElementsAre("PTP(\"JPP\",-45,0,90,0,90,0,35,200,0,false)"));
}

TEST(ScriptReader, convertsAsTheControllerDoesWithAWarning) {
  EXPECT_THAT(textsOf("PTP(\"JPP\",0,0,90,0,90,0,35.9,200,0,false)"),
              ElementsAre("PTP(\"JPP\",0,0,90,0,90,0,35,200,0,false)"));
}

TEST(ScriptReader, takesOnlyTheBranchThatIsRun) {
  EXPECT_THAT(textsOf("int n = 3\nbool ok = n > 2 ? ChangeLoad(1) : ChangeLoad(2)"),
              ElementsAre("ChangeLoad(1)"));
}

TEST(ScriptReader, goesOnWithWhatCallsAnswer) {
  EXPECT_THAT(
      textsOf("bool done = Pause()\nint state = WaitQueueTag(1, 500)\nChangeLoad(done ? state + 1 : 0)"),
      ElementsAre("Pause()", "WaitQueueTag(1,500)", "ChangeLoad(2)"));
}

TEST(ScriptReader, endsWithItsExit) {
  EXPECT_THAT(textsOf("Pause()\nScriptExit()\nResume()"), ElementsAre("Pause()", "ScriptExit()"));
}

TEST(ScriptReader, takesOutputsOneByOneAndAllAtOnce) {
  EXPECT_THAT(
      textsOf("byte on = 1\nIO[\"EndModule\"].DO = {1, 0, 0, on}\nIO[\"ControlBox\"].InstantDO[on + 1] = on"),
      ElementsAre("IO[\"EndModule\"].DO[0]=1", "IO[\"EndModule\"].DO[1]=0", "IO[\"EndModule\"].DO[2]=0",
                  "IO[\"EndModule\"].DO[3]=1", "IO[\"ControlBox\"].InstantDO[2]=1"));
}

TEST(ScriptReader, takesTheAnalogOutputAndRefusesWhatItCannotGive) {
  EXPECT_THAT(textsOf("float v = 1.5\nIO[\"ControlBox\"].AO[0] = v\nIO[\"ControlBox\"].InstantAO = {-10}"),
              ElementsAre("IO[\"ControlBox\"].AO[0]=1.5", "IO[\"ControlBox\"].InstantAO[0]=-10"));
  EXPECT_FALSE(readScript("IO[\"ControlBox\"].AO[0] = 10.5"));
}

TEST(ScriptReader, passesOverWhatIsNoCommandOfMotion) {
  EXPECT_THAT(textsOf("ListenSend(90, \"hello\")\n\n// nothing"), IsEmpty());
  EXPECT_THAT(textsOf(""), IsEmpty());
}

TEST(ScriptReader, knowsTheLineOfEachCommand) {
  const auto read = readScript("\r\nChangeBase(\"RobotBase\")\r\n// home\r\n\r\nPause()\nResume()\r\n");
  ASSERT_TRUE(read);
  std::vector<int> lines;
  for (const auto& [line, command] : *read) lines.push_back(line);
  EXPECT_THAT(lines, ElementsAre(2, 5, 6));
}

TEST(ScriptReader, tellsEveryFaultyLine) {
  const auto read = readScript("Pause(\r\n\r\nResume()\r\nQueueTag(99)\r\nnothing");
  ASSERT_FALSE(read);
  std::vector<int> lines;
  for (const tm_script::Fault& fault : read.error()) lines.push_back(fault.line);
  EXPECT_THAT(lines, ElementsAre(1, 4, 5));
}

struct Unreadable {
  const char* script;
  const char* said;
};
void PrintTo(const Unreadable& unreadable, std::ostream* out) {
  *out << unreadable.script;
}

class NotRead : public ::testing::TestWithParam<Unreadable> {};

TEST_P(NotRead, saysWhy) {
  const auto read = readScript(GetParam().script);
  ASSERT_FALSE(read) << GetParam().script;
  EXPECT_THAT(read.error().front().reason, HasSubstr(GetParam().said));
}

// What only the robot knows.
INSTANTIATE_TEST_SUITE_P(
    Robot, NotRead,
    ::testing::Values(Unreadable{"ChangeLoad(var_of_the_project)", "ChangeLoad(string) is not defined"},
                      Unreadable{"float[] now = Robot[0].Joint", "Robot"},
                      Unreadable{"byte in = IO[\"ControlBox\"].DI[0]", "known to the robot only"},
                      Unreadable{"byte out = IO[\"ControlBox\"].DO[0]", "known to the robot only"},
                      Unreadable{"IO[\"ExtModule0\"].DO[2]=1", "known to the robot only"},
                      Unreadable{"Vision_DoJob(\"a\")", "Vision_DoJob"}),
    [](const auto& test) { return testName(test.index, test.param.script); });

// What no robot takes.
INSTANTIATE_TEST_SUITE_P(
    Controller, NotRead,
    ::testing::Values(Unreadable{"PTP(\"TPP\",1,2,3,4,5,6,7,8,9,true)", "PTP takes the formats JPP, CPP"},
                      Unreadable{"PTP(\"JPP\",1,2,3,4,5,6,7,8,9,true,0,2,4)", "a pose is for CPP only"},
                      Unreadable{"Move_Line(\"JPP\",1,2,3,4,5,6,7,8,9,true)", "TPP, TPR, TAP, TAR"},
                      Unreadable{"PLine(\"CPP\",1,2,3,4,5,6,100,200,50)", "JAP, CAP"},
                      Unreadable{"string format = \"TPP\"\nPTP(format,1,2,3,4,5,6,7,8,9,true)", "JPP, CPP"},
                      Unreadable{"QueueTag(0)", "1 to 15"}, Unreadable{"QueueTag(1,2)", "0 to 1"},
                      Unreadable{"int tag = 16\nQueueTag(tag)", "1 to 15"},
                      Unreadable{"PVTEnter(2)", "0 to 1"}, Unreadable{"StopAndClearBuffer(3)", "0 to 2"},
                      Unreadable{"ScriptExit(2)", "0 to 1"}, Unreadable{"IO[\"EndModule\"].DO[4]=1", "4"},
                      Unreadable{"IO[\"EndModule\"].DO[0]=2", "2"},
                      Unreadable{"byte two = 2\nIO[\"EndModule\"].DO[0] = two", "0 or 1"},
                      Unreadable{"ChangeBase(\"\")", "is not a name"},
                      Unreadable{"ChangeBase(\"a\tb\")", "is not a name"}, Unreadable{"pause()", "pause"},
                      Unreadable{"Pause(1)", "Pause"}, Unreadable{"PTP()", "PTP"},
                      Unreadable{"ChangeBase(1,2,3,4,5)", "ChangeBase"}, Unreadable{"Pause(", ""},
                      Unreadable{"Pause() Resume()", ""}, Unreadable{"ChangeLoad(1 2)", ""},
                      Unreadable{"int n = 1 / 0", ""}),
    [](const auto& test) { return testName(test.index, test.param.script); });

TEST(ScriptReader, takesNoNumberThatIsNotFinite) {
  std::string script = "double big = 99999999999999999999.0\n";
  for (int i = 0; i < 6; ++i) script += "big *= big\n";
  EXPECT_FALSE(readScript(script + "ChangeLoad(big)"));
}

}  // namespace
}  // namespace cobot_command::script
