// The status port: the periodic stream, and what requests are answered.
#include <cstring>

#include "simulated_robot.h"
#include "streamed_items.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

using protocol::StatusFrame;

std::vector<float> floats(const StatusFrame& frame, const std::string& name) {
  return protocol::item::asFloats(itemNamed(frame, name)).value_or(std::vector<float>{});
}

class StatusServerTest : public ::testing::Test {
 protected:
  StatusFrame nextFrame() {
    robot.heard(status);
    robot.wait(15ms);
    const auto frames = framesIn(robot.heard(status));
    EXPECT_EQ(frames.size(), 1U);
    return frames.at(0);
  }
  StatusFrame request(int mode, const std::string& content) {
    robot.heard(status);
    robot.send(status, protocol::encode(StatusFrame{"q7", mode, content}), Port::Status);
    return framesIn(robot.heard(status)).at(0);
  }
  std::string raw(const std::string& bytes) {
    robot.heard(status);
    robot.send(status, bytes, Port::Status);
    return robot.heard(status);
  }

  SimulatedRobot robot;
  ClientId status = robot.connect(Port::Status);
};

TEST_F(StatusServerTest, streamsWithinEachPeriodWithIdsFromZeroToNine) {
  robot.wait(15ms * 25);
  const auto frames = framesIn(robot.heard(status));
  ASSERT_EQ(frames.size(), 25U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].id, std::to_string((i + 1) % 10));
    EXPECT_EQ(frames[i].mode, 1);
  }
}

TEST_F(StatusServerTest, streamsTheTableOfTheVendorsDriverInItsOrder) {
  const std::vector<std::string> expected{"Robot_Link",       "Robot_Error",
                                          "Project_Run",      "Project_Pause",
                                          "Safeguard_A",      "ESTOP",
                                          "Camera_Light",     "Error_Code",
                                          "Joint_Angle",      "Coord_Robot_Flange",
                                          "Coord_Robot_Tool", "TCP_Force",
                                          "TCP_Force3D",      "TCP_Speed",
                                          "TCP_Speed3D",      "Joint_Speed",
                                          "Joint_Torque",     "Project_Speed",
                                          "MA_Mode",          "Robot_Light",
                                          "Ctrl_DO0",         "Ctrl_DO1",
                                          "Ctrl_DO2",         "Ctrl_DO3",
                                          "Ctrl_DO4",         "Ctrl_DO5",
                                          "Ctrl_DO6",         "Ctrl_DO7",
                                          "Ctrl_DI0",         "Ctrl_DI1",
                                          "Ctrl_DI2",         "Ctrl_DI3",
                                          "Ctrl_DI4",         "Ctrl_DI5",
                                          "Ctrl_DI6",         "Ctrl_DI7",
                                          "Ctrl_AO0",         "Ctrl_AI0",
                                          "Ctrl_AI1",         "End_DO0",
                                          "End_DO1",          "End_DO2",
                                          "End_DO3",          "End_DI0",
                                          "End_DI1",          "End_DI2",
                                          "End_AI0"};
  ASSERT_EQ(expected.size(), 47U);
  const auto items = itemsOf(nextFrame());
  ASSERT_GE(items.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(items[i].name, expected[i]);
}

TEST_F(StatusServerTest, saysWhereTheArmStands) {
  const StatusFrame frame = nextFrame();
  EXPECT_EQ(floats(frame, "Joint_Angle"), (std::vector<float>{0, 0, 90, 0, 90, 0}));
  const std::vector<float> pose = floats(frame, "Coord_Robot_Flange"),
                           expected{417.5F, -122.3F, 361.05F, 180, 0, 90};
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(std::abs(pose.at(i)), std::abs(expected[i]), 1e-3);
  EXPECT_EQ(floats(frame, "Joint_Speed"), std::vector<float>(6, 0.0F));
  EXPECT_TRUE(flag(frame, "Project_Run"));
  EXPECT_FALSE(flag(frame, "Robot_Error"));
}

TEST_F(StatusServerTest, saysHowFastTheArmMoves) {
  robot.script(robot.connect(), "1", "Line(\"CAP\",417.5,77.7,361.05,180,0,90,100,200,0,false)");
  robot.wait(1s);
  const StatusFrame frame = nextFrame();
  const auto speed = floats(frame, "TCP_Speed");
  EXPECT_NEAR(speed.at(0), 0.0, 1e-2);
  EXPECT_NEAR(speed.at(1), 100.0, 1e-2);
  EXPECT_NEAR(speed.at(2), 0.0, 1e-2);
  EXPECT_NEAR(protocol::item::asFloat(itemNamed(frame, "TCP_Speed3D")).value(), 100.0, 1e-2);
}

TEST_F(StatusServerTest, saysWhichToolAndBaseCount) {
  robot.script(robot.connect(), "1", "ChangeBase(100,0,0,0,0,0)\r\nChangeTCP(0,0,50,0,0,0,1.5)");
  const StatusFrame frame = nextFrame();
  EXPECT_EQ(floats(frame, "Base_Value").at(0), 100.0F);
  EXPECT_EQ(floats(frame, "TCP_Value").at(2), 50.0F);
  EXPECT_EQ(protocol::item::asFloat(itemNamed(frame, "TCP_Mass")), 1.5F);
  EXPECT_NEAR(floats(frame, "Coord_Base_Flange").at(0), 317.5, 1e-3);
  EXPECT_NEAR(floats(frame, "Coord_Robot_Tool").at(2), 311.05, 1e-3);
  EXPECT_NEAR(floats(frame, "Coord_Base_Tool").at(0), 317.5, 1e-3);
}

TEST_F(StatusServerTest, saysThatAMotionFailed) {
  robot.script(robot.connect(), "1", "PTP(\"CPP\",2000,0,300,180,0,90,10,200,0,false)");
  const StatusFrame frame = nextFrame();
  EXPECT_TRUE(flag(frame, "Robot_Error"));
  EXPECT_EQ(protocol::item::asInt(itemNamed(frame, "Error_Code")), 0x01);
}

TEST_F(StatusServerTest, saysPauseEmergencyStopAndThatNoProjectRuns) {
  robot.script(robot.connect(), "1", "Pause()");
  EXPECT_TRUE(flag(nextFrame(), "Project_Pause"));
  robot.setEmergencyStop(true);
  const StatusFrame frame = nextFrame();
  EXPECT_TRUE(flag(frame, "ESTOP"));
  EXPECT_FALSE(flag(frame, "Project_Run"));
}

TEST_F(StatusServerTest, tellsAllClientsTheSame) {
  const ClientId other = robot.connect(Port::Status);
  robot.wait(45ms);
  const std::string stream = robot.heard(other);
  EXPECT_FALSE(stream.empty());
  EXPECT_EQ(robot.heard(status), stream);
}

TEST_F(StatusServerTest, hasNothingToDoWithoutClients) {
  robot.disconnect(status, Port::Status);
  EXPECT_EQ(robot.controller().nextEvent(), Instant::max());
  robot.wait(24h);
  const ClientId late = robot.connect(Port::Status);
  robot.wait(15ms);
  EXPECT_EQ(framesIn(robot.heard(late)).size(), 1U);
}

TEST_F(StatusServerTest, answersAReadRequestWithTheItems) {
  const StatusFrame answer = request(11, readRequest({"Robot_Model", "DHTable", "ESTOP"}));
  EXPECT_EQ(answer.id, "q7");
  EXPECT_EQ(answer.mode, 11);
  EXPECT_EQ(itemNamed(answer, "Robot_Model").value, "TM5-700");
  EXPECT_FALSE(flag(answer, "ESTOP"));
  const auto dh = floats(answer, "DHTable");
  ASSERT_EQ(dh.size(), 42U);
  EXPECT_FLOAT_EQ(dh[3], 145.2F);
  EXPECT_FLOAT_EQ(dh[9], 329.0F);
  EXPECT_FLOAT_EQ(dh[20], 155.0F);
}

TEST_F(StatusServerTest, namesTheFirstItemThatDoesNotExist) {
  const StatusFrame answer = request(11, readRequest({"ESTOP", "Bogus", "Bogus2"}));
  EXPECT_EQ(answer.mode, 0);
  const auto reply = protocol::parseStatusReply(answer.content).value();
  EXPECT_EQ(reply.code, protocol::StatusReply::Code::NotExist);
  EXPECT_EQ(reply.item, "Bogus");
}

TEST_F(StatusServerTest, refusesContentThatIsNoListOfNames) {
  for (const std::string& content : {std::string(), std::string("\x05", 1), std::string("\x05\0abc", 5)}) {
    EXPECT_EQ(protocol::parseStatusReply(request(11, content).content)->code,
              protocol::StatusReply::Code::InvalidData);
  }
}

TEST_F(StatusServerTest, answersInTheFormatOfTheRequest) {
  EXPECT_EQ(request(12, "Robot_Link\r\nTCP_Name\r\nESTOP\r\nJoint_Angle").content,
            "Robot_Link=1\r\nTCP_Name=\"NOTOOL\"\r\nESTOP=false\r\nJoint_Angle={0,0,90,0,90,0}");
  EXPECT_EQ(request(13, R"([{"Item":"TCP_Mass"},{"Item":"ESTOP"}])").content,
            R"([{"Item":"TCP_Mass","Value":0.0},{"Item":"ESTOP","Value":false}])");
  EXPECT_EQ(request(12, "ESTOP\r\nBogus").content, "04,NotExist;Bogus");
}

TEST_F(StatusServerTest, refusesUnknownModes) {
  for (const int mode : {0, 4, 10, 14, 99}) {
    const StatusFrame answer = request(mode, "ESTOP");
    EXPECT_EQ(answer.mode, 0);
    EXPECT_EQ(protocol::parseStatusReply(answer.content)->code, protocol::StatusReply::Code::NotSupported);
  }
}

TEST_F(StatusServerTest, boundsItsAnswers) {
  std::string names = "DHTable";
  for (int i = 1; i < 1024; ++i) names += "\r\nDHTable";
  EXPECT_EQ(request(12, names).mode, 12);
  EXPECT_EQ(request(12, names + "\r\nESTOP").content, "03,InvalidData");
}

TEST_F(StatusServerTest, refusesFaultyFramesAsTheScriptPortDoes) {
  EXPECT_EQ(raw("$TMSVR,-1,1,11,A,*00\r\n"), "$CPERR,2,01,*49\r\n");
  EXPECT_EQ(raw("$TMSVR,2,1,,*00\r\n"), "$CPERR,2,02,*4A\r\n");
  EXPECT_EQ(raw("$TMSTA,2,00,*41\r\n"), "$CPERR,2,03,*4B\r\n");
  EXPECT_EQ(raw(protocol::encodeFrame("TMSVR", "a_b,11,x")), "$CPERR,2,04,*4C\r\n");
}

TEST_F(StatusServerTest, keepsItsPeriodHoweverOftenTimeIsAdvanced) {
  for (int i = 0; i < 1500; ++i) robot.wait(100us);
  EXPECT_EQ(framesIn(robot.heard(status)).size(), 10U);
}

}  // namespace
}  // namespace cobot_command::simulator::test
