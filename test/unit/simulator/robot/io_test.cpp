// Digital outputs: written by scripts, in the order of the queue or at once, shown in the status stream.
#include "simulated_robot.h"
#include "streamed_items.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

constexpr const char* kMove = "PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)\r\n";

class OutputsTest : public ::testing::Test {
 protected:
  void script(const std::string& text) { robot.script(client, "1", text); }
  bool gripper() { return robot.state().outputs.end_module[0]; }

  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(OutputsTest, areOffAtFirst) {
  for (const bool on : robot.state().outputs.control_box) EXPECT_FALSE(on);
  for (const bool on : robot.state().outputs.end_module) EXPECT_FALSE(on);
}

TEST_F(OutputsTest, areWrittenAtOnceWhenNothingMoves) {
  script("IO[\"EndModule\"].DO[3]=1\r\nIO[\"ControlBox\"].DO[15]=1");
  EXPECT_EQ(robot.heard(client), ok("1"));
  EXPECT_TRUE(robot.state().outputs.end_module[3]);
  EXPECT_TRUE(robot.state().outputs.control_box[15]);
  script("IO[\"EndModule\"].DO[3]=0");
  EXPECT_FALSE(robot.state().outputs.end_module[3]);
}

TEST_F(OutputsTest, waitForTheMotionsBeforeThem) {
  script(std::string(kMove) + "IO[\"EndModule\"].DO[0]=1\r\nQueueTag(1)\r\n" +
         "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)\r\nIO[\"EndModule\"].DO[0]=0");
  EXPECT_EQ(robot.heard(client), ok("1"));
  EXPECT_FALSE(gripper());
  robot.waitUntil(robot.controller().nextEvent());
  EXPECT_TRUE(gripper()) << "the first motion has just ended";
  EXPECT_EQ(robot.heard(client), tag("01,true"));
  robot.waitUntilIdle();
  EXPECT_FALSE(gripper());
}

TEST_F(OutputsTest, areWrittenDuringAMotionByInstantDo) {
  script(std::string(kMove) + "IO[\"EndModule\"].InstantDO[0]=1");
  EXPECT_TRUE(gripper());
  EXPECT_TRUE(robot.state().in_motion);
}

TEST_F(OutputsTest, areGivenUpWithTheQueue) {
  script(std::string(kMove) + "IO[\"EndModule\"].DO[0]=1");
  script("StopAndClearBuffer()");
  robot.waitUntilIdle();
  EXPECT_FALSE(gripper());
}

TEST_F(OutputsTest, areGivenUpWithAMotionThatCannotBeMade) {
  script("PTP(\"CPP\",2000,0,0,0,0,0,100,200,0,false)\r\nIO[\"EndModule\"].DO[0]=1");
  EXPECT_FALSE(gripper());
}

TEST_F(OutputsTest, stayWhenTheProjectStopsAndStarts) {
  script("IO[\"EndModule\"].DO[0]=1");
  robot.stopProject();
  robot.runProject();
  EXPECT_TRUE(gripper()) << "what a gripper holds must not fall";
}

TEST_F(OutputsTest, makeAnErrorOfTheLineWithAWrongModuleIndexOrValue) {
  script(
      "Pause()\r\nIO[\"ExtModule0\"].DO[0]=1\r\nIO[\"EndModule\"].DO[4]=1\r\nIO[\"ControlBox\"].DO[16]=1\r\n"
      "IO[\"EndModule\"].DO[0]=2\r\nIO[\"EndModule\"].DO[0]=-1");
  EXPECT_EQ(robot.heard(client), error("1", "2;3;4;5;6"));
  EXPECT_FALSE(robot.state().project_paused) << "nothing of a faulty script is executed";
}

TEST_F(OutputsTest, areStreamedAsBytes) {
  const ClientId status = robot.connect(Port::Status);
  script("IO[\"EndModule\"].DO[2]=1\r\nIO[\"ControlBox\"].DO[7]=1\r\nIO[\"ControlBox\"].DO[8]=1");
  robot.wait(15ms);
  const auto frame = framesIn(robot.heard(status)).at(0);
  EXPECT_EQ(itemNamed(frame, "End_DO2").value, "\x01");
  EXPECT_EQ(itemNamed(frame, "End_DO1").value, std::string(1, '\0'));
  EXPECT_EQ(itemNamed(frame, "Ctrl_DO7").value, "\x01");
  robot.send(status, protocol::encode(protocol::StatusFrame{"q", 11, readRequest({"Ctrl_DO8", "Ctrl_DO9"})}),
             Port::Status);
  const auto answer = framesIn(robot.heard(status)).at(0);
  EXPECT_EQ(itemNamed(answer, "Ctrl_DO8").value, "\x01");
  EXPECT_EQ(itemNamed(answer, "Ctrl_DO9").value, std::string(1, '\0'));
}

}  // namespace
}  // namespace cobot_command::simulator::test
