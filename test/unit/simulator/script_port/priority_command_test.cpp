// Stop and exit with a literal argument: they do not wait for their turn (TMflow 1.82; TM 1.4).
#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

class PriorityCommandTest : public ::testing::Test {
 protected:
  void SetUp() override {
    robot.script(client, "1", "PTP(\"JPP\",90,0,90,0,90,0,50,200,0,false)\r\nQueueTag(1,1)\r\nQueueTag(2)");
    robot.script(client, "2", "QueueTag(3)");
    robot.wait(300ms);
    ASSERT_EQ(robot.heard(client), "");
  }

  SimulatedRobot robot = SimulatedRobot(withPriorityCommands());
  ClientId client = robot.connect();
};

TEST_F(PriorityCommandTest, stop0StopsTheMotionAndLetsTheScriptGoOn) {
  robot.script(client, "3", "StopAndClearBuffer(0)");
  robot.waitUntilIdle();
  EXPECT_LT(robot.joints()[0], 89.0);
  EXPECT_EQ(robot.heard(client), ok("3") + ok("1") + ok("2") + tag("02,true") + tag("03,true"));
}

TEST_F(PriorityCommandTest, stop1EndsTheScriptAndGoesOnWithTheNext) {
  robot.script(client, "3", "StopAndClearBuffer(1)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + ok("3") + ok("2") + tag("03,true"));
}

TEST_F(PriorityCommandTest, stop2DropsTheBufferedScriptsWithoutAReply) {
  robot.script(client, "3", "StopAndClearBuffer(2)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + ok("3"));
}

TEST_F(PriorityCommandTest, exitStopsEverythingAndLeavesTheNode) {
  robot.script(client, "3", "ScriptExit(0)");
  EXPECT_EQ(robot.heard(client), ok("1") + ok("3"));
  EXPECT_FALSE(robot.state().listening);
  robot.script(client, "4", "QueueTag(1)");
  EXPECT_EQ(robot.heard(client), "$CPERR,2,F1,*3F\r\n");
  robot.wait(1s);
  EXPECT_LT(robot.joints()[0], 89.0);
  EXPECT_EQ(robot.heard(client), entered());
}

TEST_F(PriorityCommandTest, isTheOnlyLineOfItsScriptThatIsExecuted) {
  robot.script(client, "3", "QueueTag(9)\r\nStopAndClearBuffer(2)\r\nQueueTag(10)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + ok("3"));
}

TEST_F(PriorityCommandTest, exitBeatsStop) {
  robot.script(client, "3", "StopAndClearBuffer(0)\r\nScriptExit(1)");
  EXPECT_FALSE(robot.state().listening);
}

TEST_F(PriorityCommandTest, inAFaultyScriptWaitsForItsTurnAndIsRefused) {
  robot.script(client, "3", "StopAndClearBuffer(2)\r\nBogus()");
  EXPECT_EQ(robot.heard(client), "");
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
}

}  // namespace
}  // namespace cobot_command::simulator::test
