// The operator's side as lines of text.
#include "cobot_command/simulator/control_line.h"

#include "simulated_robot.h"
#include "test_names.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

using ::testing::HasSubstr;

class ControlLineTest : public ::testing::Test {
 protected:
  OperatorReply say(const std::string& line) { return control(robot.controller(), line, robot.now()); }
  void expectDone(const std::string& line) {
    const OperatorReply reply = say(line);
    EXPECT_TRUE(reply.done) << reply.text;
    EXPECT_EQ(reply.text.find('\n'), std::string::npos) << "one line";
    EXPECT_NE(reply.text, "");
  }
  RobotState state() { return robot.state(); }

  SimulatedRobot robot;
};

TEST_F(ControlLineTest, stopsAndRunsTheProject) {
  expectDone("stop");
  EXPECT_FALSE(state().project_running);
  expectDone("  run \r");
  EXPECT_TRUE(state().project_running);
}

TEST_F(ControlLineTest, pausesAndResumesIt) {
  expectDone("pause");
  EXPECT_TRUE(state().project_paused);
  expectDone("resume");
  EXPECT_FALSE(state().project_paused);
}

TEST_F(ControlLineTest, movesTheFlow) {
  expectDone("leave");
  EXPECT_FALSE(state().listening);
  expectDone("enter");
  EXPECT_TRUE(state().listening);
}

TEST_F(ControlLineTest, worksTheSwitchesOfTheCell) {
  expectDone("safeguard open");
  EXPECT_TRUE(state().safeguard);
  expectDone("safeguard close");
  EXPECT_FALSE(state().safeguard);
  expectDone("manual");
  EXPECT_EQ(state().mode, OperatingMode::Manual);
  expectDone("auto");
  EXPECT_EQ(state().mode, OperatingMode::Automatic);
  expectDone("estop press");
  EXPECT_TRUE(state().emergency_stop);
  expectDone("estop release");
  EXPECT_FALSE(state().emergency_stop);
  expectDone("speed 35");
  EXPECT_EQ(state().project_speed_percent, 35);
  expectDone("input EndModule 2 1");
  EXPECT_TRUE(state().inputs.end_module[2]);
  expectDone("input ControlBox 0xF 1");
  EXPECT_TRUE(state().inputs.control_box[15]);
}

TEST_F(ControlLineTest, raisesAndClearsAnError) {
  expectDone("error 0x14058 joint 3, and more ");
  EXPECT_EQ(state().error_code, 0x14058);
  EXPECT_EQ(state().error_text, "joint 3, and more");
  expectDone("clear");
  EXPECT_FALSE(state().error);
}

TEST_F(ControlLineTest, turnsFaultsOnAndOff) {
  const ClientId client = robot.connect();
  const auto answer = [&] {
    robot.script(client, "1", "Resume()");
    return robot.heard(client);
  };
  expectDone("fault refuse_script 1 2;3");
  EXPECT_EQ(answer(), error("1", "2;3"));
  EXPECT_EQ(answer(), ok("1"));
  expectDone("fault drop_reply");
  EXPECT_EQ(answer(), "");
  expectDone("fault drop_reply off");
  expectDone("fault delay_reply 1 0.5");
  EXPECT_EQ(answer(), "");
  robot.wait(500ms);
  EXPECT_EQ(robot.heard(client), ok("1"));
  expectDone("fault ignore_script");
  expectDone("no_faults");
  EXPECT_EQ(answer(), ok("1"));
  expectDone("drop_connections");
  EXPECT_EQ(answer(), "");
}

TEST_F(ControlLineTest, helps) {
  const std::string help = say("help").text;
  for (const char* command : {"run",   "stop",      "pause",   "resume",   "leave",    "enter",
                              "estop", "safeguard", "manual",  "auto",     "speed",    "error",
                              "clear", "input",     "set_tcp", "set_base", "set_load", "drop_connections",
                              "fault", "no_faults", "faults"}) {
    EXPECT_THAT(help, HasSubstr(command));
  }
  const std::string faults = say("faults").text;
  for (const KnownFault& fault : knownFaults()) EXPECT_THAT(faults, HasSubstr(fault.name + " "));
}

TEST_F(ControlLineTest, doesNothingForALineWithoutWords) {
  for (const char* line : {"", "  ", "\r"}) {
    EXPECT_TRUE(say(line).done);
    EXPECT_EQ(say(line).text, "");
  }
}

struct BadLine {
  const char* line;
  const char* said;
};
void PrintTo(const BadLine& bad, std::ostream* out) {
  *out << bad.line;
}
class BadLineTest : public ControlLineTest, public ::testing::WithParamInterface<BadLine> {};
INSTANTIATE_TEST_SUITE_P(
    ControlLine, BadLineTest,
    ::testing::Values(
        BadLine{"dance", "unknown command \"dance\": help"}, BadLine{"run fast", "\"fast\""},
        BadLine{"estop", "press or release"}, BadLine{"safeguard opened", "open or close"},
        BadLine{"speed fast", "5 to 100"}, BadLine{"speed 50%", "5 to 100"},
        BadLine{"speed 7", "in steps of 5"}, BadLine{"speed 50 60", "\"60\""},
        BadLine{"error joint", "0x14058"}, BadLine{"error 99999999999", "0x14058"},
        BadLine{"input Elsewhere 1 1", "ControlBox and EndModule"},
        BadLine{"input EndModule x 1", "the number of the input"}, BadLine{"input EndModule 1 2", "0 or 1"},
        BadLine{"input EndModule 4 1", "0 to 3"}, BadLine{"fault", "unknown fault"},
        BadLine{"fault nothing", "unknown fault \"nothing\""}, BadLine{"fault drop_tag once", "give a count"},
        BadLine{"fault drop_tag off now", "\"now\""}, BadLine{"fault delay_reply 1 soon", "in seconds"},
        BadLine{"fault delay_reply 1", "in seconds"}, BadLine{"fault delay_reply 0 61", "to 60"}),
    [](const auto& test) { return testName(test.index, test.param.line); });

TEST_P(BadLineTest, isRefusedWithWhatToDo) {
  const OperatorReply reply = say(GetParam().line);
  EXPECT_FALSE(reply.done);
  EXPECT_THAT(reply.text, HasSubstr(GetParam().said));
}

}  // namespace
}  // namespace cobot_command::simulator::test
