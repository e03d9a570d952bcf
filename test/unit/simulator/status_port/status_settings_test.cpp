// What the settings make of the status port: format, items, version, variables.
#include "simulated_robot.h"
#include "streamed_items.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

using protocol::ItemFormat;
using protocol::StatusFrame;
using ::testing::HasSubstr;

/// A robot with these settings, and the first frame of its stream.
struct Streaming {
  explicit Streaming(const Settings& settings) : robot(settings), client(robot.connect(Port::Status)) {
    robot.wait(settings.status_period);
    frame = framesIn(robot.heard(client)).at(0);
  }
  std::string read(const std::string& name) {
    robot.heard(client);
    robot.send(client, protocol::encode(StatusFrame{"q", 12, name}), Port::Status);
    return framesIn(robot.heard(client)).at(0).content;
  }
  SimulatedRobot robot;
  ClientId client;
  StatusFrame frame;
};

Settings streaming(const std::vector<std::string>& items, ItemFormat format = ItemFormat::String) {
  Settings settings;
  settings.stream_items = items;
  settings.stream_format = format;
  return settings;
}

Settings ofVersion(const std::string& version) {
  Settings settings;
  settings.tmflow_version = version;
  return settings;
}

TEST(StatusStream, holdsWhatItIsSetToHoldBehindRobotLink) {
  const Streaming stream(streaming({"ESTOP", "Joint_Angle", "Robot_Link", "ESTOP"}));
  EXPECT_EQ(stream.frame.mode, 2);
  EXPECT_EQ(stream.frame.content, "Robot_Link=1\r\nESTOP=false\r\nJoint_Angle={0,0,90,0,90,0}");
}

TEST(StatusStream, mayBeJson) {
  const Streaming stream(streaming({"Joint_Angle"}, ItemFormat::Json));
  EXPECT_EQ(stream.frame.mode, 3);
  EXPECT_EQ(stream.frame.content, R"([{"Item":"Robot_Link","Value":1},)"
                                  R"({"Item":"Joint_Angle","Value":[0.0,0.0,90.0,0.0,90.0,0.0]}])");
}

TEST(StatusStream, hasItemsBeyondItReadAllTheSame) {
  Streaming stream(streaming({"ESTOP"}));
  EXPECT_EQ(stream.read("MA_Mode"), "MA_Mode=1");
}

TEST(StatusStream, tellsTheLimitsOfTheSafetyFunctionsAndElsewhereThoseOfTheArm) {
  Settings settings = streaming({"ESTOP"});
  settings.safety_limits[1] = {degToRad(-100), degToRad(90.5), 0};
  Streaming stream(settings);
  EXPECT_EQ(stream.read("Safety_Joint_Angle_Min"), "Safety_Joint_Angle_Min={-270,-100,-155,-180,-180,-270}");
  EXPECT_EQ(stream.read("Safety_Joint_Angle_Max"), "Safety_Joint_Angle_Max={270,90.5,155,180,180,270}");
}

TEST(StatusStream, hasItsPeriod) {
  Settings settings;
  settings.status_period = 40ms;
  Streaming stream(settings);
  stream.robot.wait(400ms);
  EXPECT_EQ(framesIn(stream.robot.heard(stream.client)).size(), 10U);
}

TEST(StatusVariables, existOnTheStatusPortWhenTheyAreStreamed) {
  Settings settings = streaming({"g_names"});
  settings.variables = {R"(string[] g_names = {"a", "b"})", "float g_hidden = 1.5"};
  Streaming stream(settings);
  EXPECT_EQ(stream.frame.content, "Robot_Link=1\r\ng_names={\"a\",\"b\"}");
  EXPECT_EQ(stream.read("g_names"), "g_names={\"a\",\"b\"}");
  EXPECT_EQ(stream.read("g_hidden"), "04,NotExist;g_hidden");
}

class ItemsOfAVersion : public ::testing::TestWithParam<std::tuple<const char*, const char*, bool>> {};

TEST_P(ItemsOfAVersion, areThoseOfThatVersion) {
  const auto& [version, name, exists] = GetParam();
  Streaming stream(ofVersion(version));
  EXPECT_EQ(stream.read(name) == std::string("04,NotExist;") + name, !exists) << stream.read(name);
}

INSTANTIATE_TEST_SUITE_P(
    StatusItems, ItemsOfAVersion,
    ::testing::Values(std::tuple("1.76", "Joint_Speed", false), std::tuple("1.76", "DHTable", false),
                      std::tuple("1.76", "Error_Content", true), std::tuple("1.76", "Ext7_AI", true),
                      std::tuple("1.80", "Joint_Speed", true), std::tuple("1.80", "Error_Content", false),
                      std::tuple("1.80", "Robot_Mode", true), std::tuple("1.80", "Joint_Torque_Min", false),
                      std::tuple("1.82", "Robot_Mode", false), std::tuple("1.82", "Joint_Torque_Min", false),
                      std::tuple("1.84", "Joint_Torque_Min", true), std::tuple("1.84", "Ctrl_AO1", false)));

TEST(StatusItems, tellTheToolAsItWasChanged) {
  Settings settings;
  settings.tcps["HandCamera"] = arm::toPose({0, 80, 40, 0, 0, 0});
  settings.tcps["gripper"] = arm::toPose({0, 0, 150, 0, 0, 0});
  Streaming stream(settings);
  EXPECT_EQ(stream.read("HandCamera_Value"), "HandCamera_Value={0,80,40,0,0,0}");
  const ClientId client = stream.robot.connect();
  stream.robot.script(client, "1", "ChangeTCP({0,0,100,0,0,0},2,{2,0.5,0.25,0,0,-80,0,0,0})");
  EXPECT_EQ(stream.read("TCP_Mass\r\nTCP_MOI\r\nTCP_MCF"),
            "TCP_Mass=2\r\nTCP_MOI={2,0.5,0.25}\r\nTCP_MCF={0,0,-80,0,0,0}");
  stream.robot.script(client, "2", "TCP[\"gripper\"].MOI[1]=3\r\nChangeTCP(\"gripper\")");
  EXPECT_EQ(stream.read("TCP_MOI"), "TCP_MOI={0,3,0}");
}

TEST(StatusItems, tellTheTimesOfTheSimulatedClock) {
  Streaming stream({});
  stream.robot.wait(65s);
  EXPECT_EQ(stream.read("System_Uptime"), "System_Uptime=\"00:01:05\"");
  EXPECT_EQ(stream.read("Project_Run_Time"), "Project_Run_Time=\"00:01:05\"");
  EXPECT_EQ(stream.read("Error_Time"), "Error_Time=\"\"");
  stream.robot.operate(RaiseError{0x21, ""});
  stream.robot.stopProject();
  stream.robot.disconnect(stream.client, Port::Status);
  stream.robot.wait(24h);
  stream.client = stream.robot.connect(Port::Status);
  EXPECT_EQ(stream.read("Current_Time"), "Current_Time=\"2000-01-02 00:01:05\"");
  EXPECT_EQ(stream.read("Error_Time"), "Error_Time=\"2000-01-01 00:01:05\"");
  EXPECT_EQ(stream.read("Project_Run_Time"), "Project_Run_Time=\"00:00:00\"");
}

TEST(StatusVariables, areThoseOfScripts) {
  Settings settings = streaming({"g_count", "var_limit"});
  settings.variables = {"int g_count = 1", "double[] var_limit = {1, 2}"};
  Streaming stream(settings);
  const ClientId script = stream.robot.connect();
  stream.robot.send(script,
                    protocol::encode(protocol::ScriptRequest{"1", "g_count++\r\nvar_limit[1] = 2.5"}));
  EXPECT_EQ(stream.read("g_count\r\nvar_limit"), "g_count=2\r\nvar_limit={1,2.5}");
  stream.robot.send(stream.client, protocol::encode(StatusFrame{"w", 2, "g_count=7"}), Port::Status);
  stream.robot.send(script, protocol::encode(protocol::ScriptRequest{"2", "g_count *= 2"}));
  EXPECT_EQ(stream.read("g_count"), "g_count=14");
}

TEST(StatusVariables, areGlobalByTheirNames) {
  Settings settings = streaming({"g_count", "var_count"});
  settings.variables = {"int g_count = 1", "int var_count = 1"};
  Streaming stream(settings);
  stream.robot.send(stream.client, protocol::encode(StatusFrame{"w", 2, "g_count=7\r\nvar_count=7"}),
                    Port::Status);
  stream.robot.stopProject();
  EXPECT_EQ(stream.read("g_count\r\nvar_count"), "g_count=7\r\nvar_count=7");
  stream.robot.operate(RunProject{});
  EXPECT_EQ(stream.read("g_count\r\nvar_count"), "g_count=7\r\nvar_count=1");
}

TEST(StatusVariables, areLeftOutOfTheStreamWhenBinaryCannotSayThem) {
  Settings settings = streaming({"g_long", "ESTOP"}, ItemFormat::Binary);
  settings.variables = {"string g_long = \"" + std::string(65536, 'x') + "\""};
  const Streaming stream(settings);
  EXPECT_EQ(stream.frame.content, std::string("\x0a\0Robot_Link\x01\0\x01\x05\0ESTOP\x01\0\0", 25));
}

TEST(Settings, areCheckedAsAWhole) {
  EXPECT_EQ(faultIn(Settings{}), std::nullopt);
  EXPECT_THAT(faultIn(streaming({"Bogus"})).value().found, HasSubstr("\"Bogus\""));
  EXPECT_THAT(faultIn(ofVersion("new")).value().found, HasSubstr("is \"new\""));
  Settings settings = streaming({"g_count"});
  settings.variables = {"int g_count = 7", "int[] g_more = {}"};
  EXPECT_EQ(faultIn(settings), std::nullopt);
  for (const char* text : {"", "long x=1", "int =1", "int 1x=1", "int x y=1", "int g_count=1", "g_count=2"}) {
    settings.variables = {"int g_count = 7", text};
    EXPECT_THAT(faultIn(settings).value().found, HasSubstr("declares no variable")) << text;
  }
  settings.variables = {"bool ESTOP = true"};
  EXPECT_THAT(faultIn(settings).value().found, HasSubstr("ESTOP is a predefined item"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
