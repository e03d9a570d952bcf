// Write requests on the status port: who may write what, what is refused, and what it does.
#include "simulated_robot.h"
#include "streamed_items.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

using protocol::StatusFrame;
using ::testing::StartsWith;

class StatusWriting : public ::testing::Test {
 protected:
  StatusWriting() { listen("10.0.0.7"); }

  void start(const Settings& settings, const std::string& address = "10.0.0.7") {
    robot = std::make_unique<SimulatedRobot>(settings);
    listen(address);
  }
  void listen(const std::string& address) {
    client = 900;
    robot->controller().clientConnected(Port::Status, client, robot->now(), address);
  }
  std::string request(int mode, const std::string& content) {
    robot->heard(client);
    robot->send(client, protocol::encode(StatusFrame{"w", mode, content}), Port::Status);
    return framesIn(robot->heard(client)).at(0).content;
  }
  std::string write(const std::string& lines) { return request(2, lines); }
  std::string read(const std::string& name) { return request(12, name); }

  std::unique_ptr<SimulatedRobot> robot = std::make_unique<SimulatedRobot>();
  ClientId client = 0;
};

TEST_F(StatusWriting, setsOutputsInEachFormat) {
  EXPECT_EQ(request(1, std::string("\x08\0Ctrl_DO0\x01\0\x01", 13)), "00,OK");
  EXPECT_EQ(request(2, "Ctrl_DO15=1\r\nEnd_DO3=1"), "00,OK");
  EXPECT_EQ(request(3, R"([{"Item":"Ctrl_AO0","Value":2.5},{"Item":"Camera_Light","Value":1}])"), "00,OK");
  EXPECT_TRUE(robot->state().outputs.control_box[0]);
  EXPECT_TRUE(robot->state().outputs.control_box[15]);
  EXPECT_TRUE(robot->state().outputs.end_module[3]);
  EXPECT_EQ(robot->state().analog_output, 2.5F);
  EXPECT_EQ(read("Camera_Light\r\nCtrl_AO0"), "Camera_Light=1\r\nCtrl_AO0=2.5");
  EXPECT_EQ(write("Ctrl_DO0=0"), "00,OK");
  EXPECT_FALSE(robot->state().outputs.control_box[0]);
}

TEST_F(StatusWriting, isSeenByTheRequestBehindItInTheSamePiece) {
  robot->send(client,
              protocol::encode(StatusFrame{"a", 2, "Ctrl_DO1=1"}) +
                  protocol::encode(StatusFrame{"b", 12, "Ctrl_DO1"}),
              Port::Status);
  EXPECT_EQ(framesIn(robot->heard(client)).at(1).content, "Ctrl_DO1=1");
}

TEST_F(StatusWriting, isForTheClientsOfTheList) {
  Settings settings;
  settings.write_clients = {"10.0.0.8"};
  start(settings, "10.0.0.7");
  EXPECT_EQ(write("Ctrl_DO0=1"), "02,WritePermission");
  EXPECT_EQ(request(3, "no JSON"), "02,WritePermission");
  EXPECT_EQ(request(99, "Ctrl_DO0=1"), "01,NotSupport");
  EXPECT_EQ(read("Ctrl_DO0"), "Ctrl_DO0=0");
  start(settings, "10.0.0.8");
  EXPECT_EQ(write("Ctrl_DO0=1"), "00,OK");
}

TEST_F(StatusWriting, isRefusedWithTheFirstReasonInTheOrderOfTheChecks) {
  robot->operate(SetOperatingMode{OperatingMode::Manual});
  EXPECT_EQ(write("Ctrl_DO0"), "03,InvalidData");
  EXPECT_EQ(write("Project_Speed=7\r\nRobot_Link=1\r\nBogus=1\r\nBogus2=1"), "04,NotExist;Bogus");
  EXPECT_EQ(write("Project_Speed=7\r\nRobot_Link=1"), "05,ReadOnly;Robot_Link");
  EXPECT_EQ(write("Ctrl_DO0=7\r\nProject_Speed=7"), "06,ModeError;Project_Speed");
  EXPECT_EQ(write("Ctrl_DO1=1\r\nCtrl_DO0=7"), "07,ValueError;Ctrl_DO0");
  EXPECT_FALSE(robot->state().outputs.control_box[1]);
}

TEST_F(StatusWriting, takesWhatTheOperatorDoesInAutomaticModeAlone) {
  robot->operate(SetOperatingMode{OperatingMode::Manual});
  for (const char* name : {"Project_Name=\"x\"", "Project_Speed=50", "Stick_PlayPause=1", "Stick_Plus=1",
                           "Stick_Minus=1", "Auto_Remote_Active=true"}) {
    EXPECT_THAT(write(name), StartsWith("06,ModeError;")) << name;
  }
  EXPECT_EQ(write("Stick_Stop=1"), "00,OK");
  EXPECT_FALSE(robot->state().project_running);
}

TEST_F(StatusWriting, setsTheProjectSpeedInStepsOfFive) {
  for (const char* wrong : {"0", "47", "105", "-5", "50.0", "\"50\""}) {
    EXPECT_EQ(write(std::string("Project_Speed=") + wrong), "07,ValueError;Project_Speed");
  }
  EXPECT_EQ(write("Project_Speed=50"), "00,OK");
  EXPECT_EQ(robot->state().project_speed_percent, 50);
}

TEST_F(StatusWriting, changesTheSpeedByTheStickBetweenFiveAndAHundredPercent) {
  EXPECT_EQ(write("Stick_Plus=1"), "00,OK");
  EXPECT_EQ(robot->state().project_speed_percent, 100);
  EXPECT_EQ(write("Stick_Minus=1"), "00,OK");
  EXPECT_EQ(robot->state().project_speed_percent, 95);
  EXPECT_EQ(write("Project_Speed=5\r\nStick_Minus=1"), "00,OK");
  EXPECT_EQ(robot->state().project_speed_percent, 5);
}

TEST_F(StatusWriting, runsPausesAndStopsTheProjectByTheStick) {
  EXPECT_EQ(write("Stick_PlayPause=1"), "00,OK");
  EXPECT_TRUE(robot->state().project_paused);
  EXPECT_EQ(write("Stick_PlayPause=1"), "00,OK");
  EXPECT_FALSE(robot->state().project_paused);
  EXPECT_EQ(write("Stick_Stop=0"), "00,OK");
  EXPECT_TRUE(robot->state().project_running);
  EXPECT_EQ(write("Stick_Stop=1"), "00,OK");
  EXPECT_FALSE(robot->state().project_running);
  robot->setEmergencyStop(true);
  EXPECT_EQ(write("Stick_PlayPause=1"), "00,OK");
  EXPECT_FALSE(robot->state().project_running);
  robot->setEmergencyStop(false);
  EXPECT_EQ(write("Stick_PlayPause=1"), "00,OK");
  EXPECT_TRUE(robot->state().project_running);
  EXPECT_EQ(read("Stick_PlayPause"), "Stick_PlayPause=false");
}

TEST_F(StatusWriting, namesTheProject) {
  EXPECT_EQ(write("Project_Name=\"Other\""), "00,OK");
  EXPECT_EQ(read("Project_Name"), "Project_Name=\"Other\"");
  EXPECT_EQ(write("Project_Name=\"\""), "07,ValueError;Project_Name");
  EXPECT_EQ(write("Project_Name=\"" + std::string(129, 'x') + '"'), "07,ValueError;Project_Name");
}

TEST_F(StatusWriting, keepsTypeAndSizeOfVariables) {
  Settings settings;
  settings.variables = {"int[] adata = {0, 0, 0, 0}", "string g_text"};
  settings.stream_items = {"adata", "g_text"};
  start(settings);
  EXPECT_EQ(write("adata={1,2,3}"), "07,ValueError;adata");
  EXPECT_EQ(write("adata={1,2,3,4.5}"), "07,ValueError;adata");
  EXPECT_EQ(write("adata={1,2,3,4}\r\ng_text=\"Hi\""), "00,OK");
  EXPECT_EQ(read("adata\r\ng_text"), "adata={1,2,3,4}\r\ng_text=\"Hi\"");
  EXPECT_EQ(write("g_text=\"" + std::string(65536, 'x') + '"'), "07,ValueError;g_text");
}

}  // namespace
}  // namespace cobot_command::simulator::test
