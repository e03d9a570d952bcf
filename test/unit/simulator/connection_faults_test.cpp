// The faults of the world that are of whole connections and of the status port.
#include "faults_fixture.h"
#include "streamed_items.h"

namespace cobot_command::simulator::test {
namespace {

using ::testing::ElementsAre;

// --- Connections.
TEST_F(FaultsTest, fallSilentOnTheScriptPort) {
  fault("silence");
  robot.script(client, "1", "Pause()");
  EXPECT_EQ(robot.ask(client, "00"), "");
  EXPECT_FALSE(robot.state().project_paused) << "what comes in is not heard";
  off("silence");
  EXPECT_EQ(robot.ask(client, "00"), kListening) << "the connection is still there";
}

TEST_F(FaultsTest, letTheArmGoOnInSilence) {
  robot.script(client, "1", kMove);
  EXPECT_EQ(robot.heard(client), ok("1"));
  fault("silence");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_NEAR(robot.joints()[0], 20.0, 1e-9);
}

TEST_F(FaultsTest, dropAllConnectionsAndLeaveThePortsOpen) {
  robot.connect(Port::Status);
  robot.events();
  EXPECT_TRUE(robot.operate(DropConnections{}).done);
  EXPECT_THAT(robot.events(), ElementsAre("x1", "x2"));
  client = robot.connect();
  EXPECT_EQ(robot.ask(client, "00"), kListening);
}

TEST_F(FaultsTest, closeAConnectionAtOnce) {
  robot.events();
  fault("close_on_connect", 1);
  robot.connect();
  EXPECT_THAT(robot.events(), ElementsAre("x2"));
  EXPECT_EQ(robot.ask(robot.connect(), "00"), kListening);
}

TEST_F(FaultsTest, refuseConnectionsThoughTheProjectRuns) {
  robot.events();
  fault("refuse_connections");
  EXPECT_THAT(robot.events(), ElementsAre("x1", "-script"));
  EXPECT_TRUE(robot.state().project_running);
  robot.connect();
  EXPECT_THAT(robot.events(), ElementsAre("x2"));
  off("refuse_connections");
  EXPECT_THAT(robot.events(), ElementsAre("+script"));
  robot.stopProject();
  robot.events();
  fault("refuse_connections");
  robot.runProject();
  off("refuse_connections");
  EXPECT_THAT(robot.events(), ElementsAre("+script")) << "opened once, when the fault is over";
}

TEST_F(FaultsTest, pretendToBeSomethingElse) {
  fault("impostor", 1, "220 ready");
  SimulatedController& controller = robot.controller();
  controller.clientConnected(Port::Script, 77, robot.now());
  robot.send(77, "$TMSTA,2,00,*41\r\n");
  EXPECT_EQ(robot.heard(77), "220 ready\r\n");
  EXPECT_EQ(robot.ask(client, "00"), kListening) << "older connections are as they were";
  EXPECT_EQ(robot.ask(robot.connect(), "00"), kListening);
  robot.events();
  robot.operate(DropConnections{});
  EXPECT_THAT(robot.events(), ::testing::Contains("x77"));
}

// --- The status port.
TEST_F(FaultsTest, stopTheStatusStream) {
  const ClientId status = robot.connect(Port::Status);
  fault("drop_stream");
  robot.wait(1s);
  EXPECT_EQ(robot.heard(status), "");
  off("drop_stream");
  robot.wait(15ms);
  EXPECT_EQ(framesIn(robot.heard(status)).size(), 1U);
}

TEST_F(FaultsTest, takeItemsOutOfTheDataTable) {
  const ClientId status = robot.connect(Port::Status);
  fault("hide_items", 0, "Joint_Speed Robot_Model");
  robot.wait(15ms);
  for (const auto& item : itemsOf(framesIn(robot.heard(status)).at(0))) EXPECT_NE(item.name, "Joint_Speed");
  robot.send(status, protocol::encode(protocol::StatusFrame{"q", 11, readRequest({"Robot_Model"})}),
             Port::Status);
  const auto reply = protocol::parseStatusReply(framesIn(robot.heard(status)).at(0).content).value();
  EXPECT_EQ(reply.code, protocol::StatusReply::Code::NotExist);
  off("hide_items");
  robot.wait(15ms);
  itemNamed(framesIn(robot.heard(status)).at(0), "Joint_Speed");
}

}  // namespace
}  // namespace cobot_command::simulator::test
