// Whatever a client sends, the controller goes on.
#include <random>

#include "simulated_robot.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

constexpr const char* kQuery = "$TMSTA,2,00,*41\r\n";

std::vector<std::string> validFrames() {
  const auto script = [](const std::string& text) { return protocol::encodeFrame("TMSCT", "1," + text); };
  return {
      script("PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)"),
      script("PTP(\"CPP\",417.5,-122.3,343.9,180,0,90,10,200,0,false,0,2,4)\r\nQueueTag(1,1)"),
      script("Line(\"CAR\",417.5,-122.3,343.9,180,0,90,100,200,50,false)"),
      script("Circle(\"CAP\",417.5,-122.3,343.9,180,0,90,381.7,208.74,343.9,180,0,135,100,200,50,270,false)"),
      script("Move_PTP(\"TPP\",0,0,10,45,0,0,10,200,0,false)"),
      script("Move_Line(\"TAP\",0,0,10,45,0,0,125,200,0,false)"),
      script("ChangeBase(20,30,10,0,0,90)"),
      script("ChangeTCP(0,0,150,0,0,90,2,2,0.5,0.5,0,0,-80,0,0,0)"),
      script("ChangeLoad(5.3)\r\nWaitQueueTag(1,5)\r\nStopAndClearBuffer()\r\nPause()\r\nResume()"),
      script("StopAndClearBuffer(2)"),
      script("ScriptExit()"),
      kQuery,
      "$TMSTA,5,01,15,*6F\r\n"};
}

/// A frame with some bytes changed, removed or doubled, its length and checksum mostly put right again.
std::string mutated(std::string frame, std::mt19937& random) {
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  const bool keeps_frame = below(4) != 0;
  const std::size_t data = frame.find(',', 7) + 1;
  std::string text = keeps_frame ? frame.substr(data, frame.size() - data - 6) : frame;
  for (std::size_t changes = 1 + below(3); changes > 0 && !text.empty(); --changes) {
    const std::size_t at = below(text.size());
    const char digits[] = "0123456789-.,\"()\r\n";
    switch (below(4)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text[at] = digits[below(sizeof digits - 1)];
        break;
      case 2:
        text.erase(at, 1 + below(5));
        break;
      default:
        text.insert(at, text.substr(at, 1 + below(5)));
        break;
    }
  }
  return keeps_frame ? protocol::encodeFrame(frame.substr(1, 5), text) : text;
}

class RobustnessTest : public ::testing::TestWithParam<unsigned> {
 protected:
  /// Answers on a fresh connection, whatever state the others are in.
  void expectAnswers(SimulatedRobot& robot) {
    const ClientId fresh = robot.connect();
    robot.heard(fresh);
    robot.send(fresh, kQuery);
    const std::string answer = robot.heard(fresh);
    EXPECT_EQ(answer.substr(0, 7), "$TMSTA,") << answer;
    robot.disconnect(fresh);
  }
};

TEST_P(RobustnessTest, answersAfterRandomBytesOnBothPorts) {
  std::mt19937 random(GetParam());
  std::uniform_int_distribution<int> byte(0, 255);
  SimulatedRobot robot;
  const ClientId script = robot.connect(), status = robot.connect(Port::Status);
  for (int i = 0; i < 300; ++i) {
    std::string bytes(static_cast<std::size_t>(byte(random)), '\0');
    for (char& c : bytes) c = static_cast<char>(byte(random));
    robot.send(script, "$TMSCT," + bytes);
    robot.send(status, "$TMSVR," + bytes, Port::Status);
    robot.wait(10ms);
    robot.heard(script), robot.heard(status);
  }
  expectAnswers(robot);
}

TEST_P(RobustnessTest, answersAfterMutatedFrames) {
  std::mt19937 random(GetParam());
  const std::vector<std::string> frames = validFrames();
  SimulatedRobot robot;
  ClientId client = robot.connect();
  for (int i = 0; i < 300; ++i) {
    robot.send(client, mutated(frames[random() % frames.size()], random));
    robot.wait(std::chrono::milliseconds(random() % 300));
    ASSERT_TRUE(robot.state().joints.allFinite());
    if (i % 50 == 49) {  // a length that swallows the rest ends with its connection
      robot.disconnect(client);
      client = robot.connect();
    }
  }
  expectAnswers(robot);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RobustnessTest, ::testing::Range(0U, 10U));

TEST(Robustness, takesClientsThatItDoesNotKnowAndThoseThatLeaveTwice) {
  SimulatedRobot robot;
  robot.send(99, kQuery);
  EXPECT_EQ(robot.heard(99), "");
  robot.disconnect(99);
  robot.disconnect(99, Port::Status);
  robot.send(99, kQuery, Port::Status);
  EXPECT_EQ(robot.heard(99), "");
}

std::string lines(const std::string& line, int count) {
  std::string script = line;
  for (int i = 1; i < count; ++i) script += "\r\n" + line;
  return script;
}

TEST(Robustness, takesAThousandItemsIntoTheQueueAndNamesTheLinesThatDoNotFit) {
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  robot.script(client, "1", "Pause()");
  robot.script(client, "2", lines("Move_PTP(\"JPP\",1,0,0,0,0,0,100,200,0,false)", 998));
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2"));
  robot.script(client, "3",
               "QueueTag(1)\r\nResume()\r\nChangeLoad(1)\r\nChangeLoad(2)\r\nIO[\"EndModule\"].DO[0]=1");
  EXPECT_EQ(robot.heard(client), error("3", "4;5"));
  EXPECT_TRUE(robot.state().project_paused);
  robot.script(client, "4", "QueueTag(1)\r\nChangeLoad(1)\r\nIO[\"EndModule\"].InstantDO[0]=1");
  EXPECT_EQ(robot.heard(client), ok("4")) << "what is done at once needs no room";
  robot.script(client, "5", "QueueTag(2)");
  EXPECT_EQ(robot.heard(client), error("5", "1"));
  robot.script(client, "6", "StopAndClearBuffer()\r\nResume()");
  robot.script(client, "7", "QueueTag(2)");
  EXPECT_EQ(robot.heard(client), ok("6") + ok("7") + tag("02,true"));
}

TEST(Robustness, letsAThousandScriptsWaitAndRefusesFurtherOnes) {
  SimulatedRobot robot(withPriorityCommands());
  const ClientId client = robot.connect();
  robot.script(client, "0", "Pause()\r\nMove_PTP(\"JPP\",1,0,0,0,0,0,100,200,0,false)\r\nQueueTag(1,1)");
  for (int i = 1; i <= 1000; ++i) robot.script(client, "a" + std::to_string(i), "Resume()");
  EXPECT_EQ(robot.heard(client), "");
  robot.script(client, "b", "Resume()");
  EXPECT_EQ(robot.heard(client), error("b", "1"));
  robot.script(client, "c", "StopAndClearBuffer(1)");
  EXPECT_THAT(robot.heard(client), ::testing::EndsWith(ok("a1000"))) << "a priority command does not wait";
}

TEST(Robustness, takesSettingsOutOfRange) {
  Settings settings;
  settings.status_period = Duration::zero();
  settings.project_speed_percent = 0;
  settings.stop_time = -1s;
  settings.reentry_delay = -1s;
  SimulatedRobot robot(settings);
  const ClientId client = robot.connect();
  robot.connect(Port::Status);
  robot.script(client, "1",
               "PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)\r\nPause()\r\nResume()\r\nScriptExit()");
  robot.wait(30s);
  EXPECT_NEAR(robot.joints()[0], 10.0, 1e-9);
  EXPECT_TRUE(robot.state().listening);
}

}  // namespace
}  // namespace cobot_command::simulator::test
