// A robot with a client, whose faults of the world are turned on and off.
#pragma once

#include <string>

#include "simulated_robot.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {

inline constexpr const char* kMove = "PTP(\"JPP\",20,0,90,0,90,0,100,200,0,false)\r\nQueueTag(1)";
inline const std::string kListening = protocol::encodeFrame("TMSTA", "00,true,Listen1");

class FaultsTest : public ::testing::Test {
 protected:
  void fault(const std::string& name, int count = 0, const std::string& text = {}, double seconds = 0) {
    const OperatorReply reply = robot.operate(SetFault{name, true, count, seconds, text});
    EXPECT_TRUE(reply.done) << reply.text;
  }
  void off(const std::string& name) { EXPECT_TRUE(robot.operate(SetFault{name, false, 0, 0, ""}).done); }
  std::string refusal(const SetFault& order) {
    const OperatorReply reply = robot.operate(order);
    EXPECT_FALSE(reply.done) << reply.text;
    return reply.text;
  }
  /// What the client hears until nothing moves any more.
  std::string run(const std::string& id, const std::string& script) {
    robot.script(client, id, script);
    robot.waitUntilIdle();
    return robot.heard(client);
  }

  SimulatedRobot robot = SimulatedRobot(withPriorityCommands());
  ClientId client = robot.connect();
};

}  // namespace cobot_command::simulator::test
