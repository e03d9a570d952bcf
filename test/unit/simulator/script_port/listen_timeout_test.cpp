// The timeouts of the Listen node: leaving it by Fail.
#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

Settings withTimeouts(Duration connection, Duration data) {
  Settings settings;
  settings.connection_timeout = connection;
  settings.data_timeout = data;
  settings.reentry_delay = 1s;
  return settings;
}

TEST(ListenTimeout, isNoneUnlessItIsSet) {
  SimulatedRobot robot;
  robot.wait(24h);
  EXPECT_TRUE(robot.state().listening);
}

TEST(ListenTimeout, leavesTheNodeWhenNobodyConnects) {
  SimulatedRobot robot(withTimeouts(500ms, 0s));
  robot.wait(499ms);
  EXPECT_TRUE(robot.state().listening);
  robot.wait(1ms);
  EXPECT_FALSE(robot.state().listening);
  robot.wait(1s);
  EXPECT_TRUE(robot.state().listening) << "the project loops";
  robot.wait(500ms);
  EXPECT_FALSE(robot.state().listening);
}

TEST(ListenTimeout, isNotOfTheConnectionOnceSomebodyHasConnected) {
  SimulatedRobot robot(withTimeouts(500ms, 0s));
  robot.disconnect(robot.connect());
  robot.wait(24h);
  EXPECT_TRUE(robot.state().listening);
}

TEST(ListenTimeout, leavesTheNodeWhenClientsSendNothing) {
  SimulatedRobot robot(withTimeouts(0s, 500ms));
  robot.wait(10s);
  EXPECT_TRUE(robot.state().listening) << "there is no client yet";
  const ClientId client = robot.connect();
  robot.wait(400ms);
  robot.ask(client, "00");
  robot.wait(499ms);
  EXPECT_TRUE(robot.state().listening) << "any frame counts";
  robot.wait(1ms);
  EXPECT_FALSE(robot.state().listening);
  robot.wait(1s);
  EXPECT_EQ(robot.heard(client), entered());
  robot.wait(500ms);
  EXPECT_FALSE(robot.state().listening) << "the client that is still there sends nothing";
}

TEST(ListenTimeout, letsTheQueuedMotionEnd) {
  Settings settings = withTimeouts(0s, 500ms);
  settings.reentry_delay = 60s;
  SimulatedRobot robot(settings);
  const ClientId client = robot.connect();
  robot.script(client, "1", "PTP(\"JPP\",45,0,90,0,90,0,10,200,0,false)\r\nQueueTag(3)");
  robot.wait(600ms);
  EXPECT_FALSE(robot.state().listening);
  EXPECT_TRUE(robot.state().in_motion);
  robot.script(client, "2", "QueueTag(4)");
  EXPECT_EQ(robot.heard(client), ok("1") + protocol::encodeFrame("CPERR", "F1"));
  robot.wait(70s);
  EXPECT_EQ(robot.heard(client), tag("03,true") + entered());
}

TEST(ListenTimeout, endsAScriptThatWaits) {
  SimulatedRobot robot(withTimeouts(0s, 500ms));
  const ClientId client = robot.connect();
  robot.script(client, "1", "PTP(\"JPP\",45,0,90,0,90,0,10,200,0,false)\r\nQueueTag(3,1)");
  robot.script(client, "2", "QueueTag(4)");
  EXPECT_EQ(robot.heard(client), "");
  robot.wait(500ms);
  EXPECT_EQ(robot.heard(client), ok("1") + protocol::encodeFrame("CPERR", "F1"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
