// The attributes of objects in scripts: IO, Robot, Point, Base, TCP.
#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

Settings project() {
  Settings settings;
  settings.bases["table"] = arm::toPose({1, 2, 3, 0, 0, 0});
  settings.tcps["gripper"] = arm::toPose({0, 0, 150, 0, 0, 0});
  settings.points["P1"] = arm::toJointVector({0, 0, 90, 0, 90, 0});
  return settings;
}

class ScriptAttributesTest : public ::testing::Test {
 protected:
  std::string run(const std::string& script) {
    robot.heard(client);
    robot.script(client, "1", script);
    return robot.heard(client);
  }
  void expectValue(const std::string& expression, const std::string& value) {
    EXPECT_EQ(run("ListenSend(90,GetString(" + expression + "))"),
              protocol::encodeFrame("TMSTA", "90," + value) + ok("1"))
        << expression;
  }

  SimulatedRobot robot = SimulatedRobot(project());
  ClientId client = robot.connect();
};

TEST_F(ScriptAttributesTest, haveTheLengthsOfTheModules) {
  expectValue("Length(IO[\"ControlBox\"].DI)", "16");
  expectValue("Length(IO[\"EndModule\"].AI)", "1");
  expectValue("Length(IO[\"Safety\"].SI)", "5");
  EXPECT_EQ(run("byte b = IO[\"ControlBox\"].DI[16]"), error("1", "1"));
  EXPECT_EQ(run("byte b = IO[\"ControlBox\"].DI[-1]"), error("1", "1"));
}

TEST_F(ScriptAttributesTest, readInputsAndOutputs) {
  robot.operate(SetInput{script::IoModule::ControlBox, 3, true});
  expectValue("IO[\"ControlBox\"].DI[3]", "1");
  EXPECT_EQ(run("IO[\"EndModule\"].InstantDO[2]=1"), ok("1"));
  expectValue("IO[\"EndModule\"].DO", "{0,0,1,0}");
}

TEST_F(ScriptAttributesTest, writeAWholeModuleWithAllItsOutputs) {
  EXPECT_EQ(run("IO[\"EndModule\"].DO={1,0,1}"), error("1", "1"));
  EXPECT_EQ(run("IO[\"EndModule\"].DO={1,0,1,0}"), ok("1"));
  EXPECT_TRUE(robot.state().outputs.end_module[2]);
  EXPECT_FALSE(robot.state().outputs.end_module[1]);
}

TEST_F(ScriptAttributesTest, setTheAnalogOutputInTheQueueOrAtOnce) {
  EXPECT_EQ(run("IO[\"ControlBox\"].AO={2.5}"), ok("1"));
  EXPECT_EQ(robot.state().analog_output, 2.5F);
  EXPECT_EQ(run("PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)\r\nIO[\"ControlBox\"].AO[0]=-3\r\n"
                "IO[\"ControlBox\"].InstantAO[0]=5"),
            ok("1"));
  expectValue("IO[\"ControlBox\"].AO[0]", "5");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.state().analog_output, -3.0F);
  EXPECT_EQ(run("IO[\"ControlBox\"].InstantAO[0]=10.5"), error("1", "1"));
}

TEST_F(ScriptAttributesTest, switchTheLightOfTheCamera) {
  EXPECT_EQ(run("Robot[0].CameraLight=1"), ok("1"));
  EXPECT_TRUE(robot.state().camera_light);
  expectValue("Robot[0].CameraLight", "1");
  EXPECT_EQ(run("Robot[0].CameraLight=2"), error("1", "1"));
}

TEST_F(ScriptAttributesTest, leaveAloneWhatCanOnlyBeRead) {
  EXPECT_EQ(run("IO[\"ControlBox\"].DI[0]=1\r\nTCP[\"NOTOOL\"].Value={1,2,3,0,0,0}"), ok("1"));
  EXPECT_FALSE(robot.state().inputs.control_box[0]);
  expectValue("TCP[\"NOTOOL\"].Value", "{0,0,0,0,0,0}");
}

TEST_F(ScriptAttributesTest, tellWhereTheRobotIs) {
  expectValue("Robot[0].Joint", "{0,0,90,0,90,0}");
  expectValue("Robot[0].BaseName", "RobotBase");
  expectValue("Robot[0].TCPSpeed3D", "0");
  expectValue("dist(Robot[0].CoordRobot,{417.5,-122.3,361.05,180,0,90}) < 0.001 ? 1 : 0", "1");
  EXPECT_EQ(run("ChangeBase(100,0,0,0,0,0)"), ok("1"));
  expectValue("dist(Robot[0].CoordBase,{317.5,-122.3,361.05,180,0,90}) < 0.001 ? 1 : 0", "1");
}

TEST_F(ScriptAttributesTest, changeABaseThatCountsFromTheNextChangeBase) {
  EXPECT_EQ(run("Base[\"table\"].Value={4,5,6,0,0,90}\r\nChangeBase(\"table\")"), ok("1"));
  EXPECT_NEAR(robot.state().base.translation().z(), 0.006, 1e-12);
  EXPECT_EQ(robot.state().base_name, "table");
  expectValue("Base[\"table\"].TeachValue", "{1,2,3,0,0,0}");
  expectValue("Base[\"table\"].Type", "C");
}

TEST_F(ScriptAttributesTest, changeAToolWithItsMass) {
  EXPECT_EQ(run("TCP[\"gripper\"].Mass=2\r\nTCP[\"gripper\"].MCF[2]=-80\r\nChangeTCP(\"gripper\")"), ok("1"));
  EXPECT_EQ(robot.state().tcp_mass, 2.0);
  expectValue("TCP[\"gripper\"].MCF", "{0,0,-80,0,0,0}");
  expectValue("TCP[\"gripper\"].Value", "{0,0,150,0,0,0}");
}

TEST_F(ScriptAttributesTest, knowTheToolOfTheCamera) {
  EXPECT_EQ(run("ChangeTCP(\"HandCamera\")"), ok("1"));
  EXPECT_EQ(robot.state().tcp_name, "HandCamera");
}

TEST_F(ScriptAttributesTest, changeAPointButNotAsItWasTaught) {
  expectValue("Point[\"P1\"].Pose", "{0,2,4}");
  EXPECT_EQ(run("Point[\"P1\"].Value={1,2,3,4,5,6}\r\nPoint[\"P1\"].Pose={1,3,5}"), ok("1"));
  expectValue("Point[\"P1\"].Value", "{1,2,3,4,5,6}");
  expectValue("Point[\"P1\"].TeachPose", "{0,2,4}");
}

/// As ListenSend() sends them: four bytes each, the lowest first.
std::string bytes(std::initializer_list<float> numbers) {
  std::string all;
  for (const float number : numbers) {
    std::uint32_t word = 0;
    std::memcpy(&word, &number, sizeof(word));
    for (int shift = 0; shift < 32; shift += 8) all += static_cast<char>(word >> shift & 0xFFU);
  }
  return all;
}

TEST_F(ScriptAttributesTest, areSentAsFloatsOfLittleEndianOneLineBehindTheOther) {
  const auto sent = [](int channel, const std::string& payload) {
    return protocol::encodeFrame("TMSTA", std::to_string(channel) + ',' + payload);
  };
  EXPECT_EQ(run("TCP[\"gripper\"].Mass=2.5\r\nTCP[\"gripper\"].MOI={1,2,3}\r\n"
                "// what it is now\r\n"
                "ListenSend(90,TCP[\"gripper\"].Value)\r\n\r\n"
                "ListenSend(91,TCP[\"gripper\"].Mass)\r\n"
                "ListenSend(92,TCP[\"gripper\"].MOI)\r\n"
                "TCP[\"gripper\"].MCF[2]=-80\r\n"
                "ListenSend(93,TCP[\"gripper\"].MCF)\r\n"
                "ListenSend(90,Base[\"table\"].Value)\r\nListenSend(94,\"end\")"),
            sent(90, bytes({0, 0, 150, 0, 0, 0})) + sent(91, bytes({2.5F})) + sent(92, bytes({1, 2, 3})) +
                sent(93, bytes({0, 0, -80, 0, 0, 0})) + sent(90, bytes({1, 2, 3, 0, 0, 0})) +
                sent(94, "end") + ok("1"));
}

TEST_F(ScriptAttributesTest, areNotSentAtAllWhenOneOfThemIsUnknown) {
  EXPECT_EQ(run("ListenSend(90,TCP[\"gripper\"].Value)\r\nListenSend(90,TCP[\"gone\"].Value)\r\n"
                "ListenSend(90,Base[\"gone\"].Value)"),
            error("1", "2;3"));
}

// The vendor's ROS drivers write outputs so (set_io).
TEST_F(ScriptAttributesTest, takeNamesWithoutQuotesWithAWarning) {
  EXPECT_EQ(run("IO[ControlBox].DO[0]=1"), protocol::encodeFrame("TMSCT", "1,OK;1"));
  EXPECT_TRUE(robot.state().outputs.control_box[0]);
  EXPECT_EQ(run("Point[P1].Pose={1,3,5}\r\nBase[table].Value[2]=9\r\nTCP[gripper].Mass=2"),
            protocol::encodeFrame("TMSCT", "1,OK;1;2;3"));
  expectValue("Point[\"P1\"].Pose", "{1,3,5}");
  EXPECT_EQ(run("IO[ControlBux].DO[0]=1\r\nRobot[arm].CameraLight=1"), error("1", "1;2"));
}

TEST_F(ScriptAttributesTest, areErrorsWhenThereAreNone) {
  EXPECT_EQ(run("Base[\"nowhere\"].Value={1,2,3,0,0,0}\r\nIO[\"ControlBox\"].XY[0]=1\r\nbyte b = "
                "Robot[1].CameraLight\r\n"
                "Point[\"P1\"].Type=1\r\nVPoint[\"v\"].Value={1,2,3,0,0,0}"),
            error("1", "1;2;3;4;5"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
