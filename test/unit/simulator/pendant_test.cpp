// What is changed on the pendant: TCPs, bases and loads of the project, which outlive its runs.
#include <cmath>
#include <limits>

#include "simulated_robot.h"
#include <gmock/gmock.h>

#include "cobot_command/simulator/control_line.h"

namespace cobot_command::simulator::test {
namespace {

using ::testing::HasSubstr;

Settings project() {
  Settings settings;
  settings.bases["table"] = arm::toPose({1, 2, 3, 0, 0, 0});
  settings.tcps["gripper"] = arm::toPose({0, 0, 150, 0, 0, 0});
  settings.tcps["big cup=2"] = arm::toPose({0, 0, 80, 0, 0, 0});
  return settings;
}

class PendantTest : public ::testing::Test {
 protected:
  void startAfresh() {
    robot.stopProject();
    robot.runProject();
    client = robot.connect();
  }
  std::string run(const std::string& script) {
    robot.heard(client);
    robot.script(client, "1", script);
    return robot.heard(client);
  }
  std::string valueOf(const std::string& expression) {
    const std::string heard = run("ListenSend(90,GetString(" + expression + "))");
    return heard.substr(0, heard.find('*'));
  }
  void expectValue(const std::string& expression, const std::string& value) {
    const std::string frame = protocol::encodeFrame("TMSTA", "90," + value);
    EXPECT_EQ(valueOf(expression), frame.substr(0, frame.find('*'))) << expression;
  }
  std::string refusal(const OperatorAction& action) {
    const OperatorReply reply = robot.operate(action);
    EXPECT_FALSE(reply.done) << reply.text;
    return reply.text;
  }
  std::string say(const std::string& line) {
    const OperatorReply reply = control(robot.controller(), line, robot.now());
    return (reply.done ? "ok: " : "error: ") + reply.text;
  }

  SimulatedRobot robot = SimulatedRobot(project());
  ClientId client = robot.connect();
};

TEST_F(PendantTest, changesATcpThatOutlivesTheProject) {
  EXPECT_EQ(robot.operate(SetTcp{"gripper", {0, 0, 160, 0, 0, 180}}).text,
            "the TCP \"gripper\" is at 0, 0, 160, 0, 0, 180");
  expectValue("TCP[\"gripper\"].Value", "{0,0,160,0,0,180}");
  startAfresh();
  expectValue("TCP[\"gripper\"].Value", "{0,0,160,0,0,180}");
  expectValue("TCP[\"gripper\"].TeachValue", "{0,0,160,0,0,180}");
}

TEST_F(PendantTest, changesABaseThatOutlivesTheProject) {
  EXPECT_TRUE(robot.operate(SetBase{"table", {400, 0.125, -20, 0, 0, -90}}).done);
  startAfresh();
  expectValue("Base[\"table\"].Value", "{400,0.125,-20,0,0,-90}");
  EXPECT_EQ(run("ChangeBase(\"table\")"), ok("1"));
  EXPECT_NEAR(robot.state().base.translation().x(), 0.4, 1e-9);
}

TEST_F(PendantTest, changesALoadThatOutlivesTheProject) {
  SetLoad load{"gripper", 2.5, {}, {}};
  EXPECT_TRUE(robot.operate(load).done);
  load.moment = {1000, 2000, 3000};
  load.mass_center = {0, 0, -80, 0, 0, 90};
  EXPECT_EQ(
      robot.operate(load).text,
      "the TCP \"gripper\" weighs 2.5 kg, inertia 1000, 2000, 3000 kg mm^2, centre at 0, 0, -80, 0, 0, 90");
  startAfresh();
  expectValue("TCP[\"gripper\"].Mass", "2.5");
  expectValue("TCP[\"gripper\"].MOI", "{1000,2000,3000}");
  expectValue("TCP[\"gripper\"].MCF", "{0,0,-80,0,0,90}");
  expectValue("TCP[\"gripper\"].Value", "{0,0,150,0,0,0}");
}

TEST_F(PendantTest, leavesInertiaAndCentreWhenOnlyTheMassIsGiven) {
  EXPECT_TRUE(robot.operate(SetLoad{"gripper", 2, std::array<double, 3>{1, 2, 3}, {}}).done);
  EXPECT_TRUE(robot.operate(SetLoad{"gripper", 3, {}, {}}).done);
  expectValue("TCP[\"gripper\"].MOI", "{1,2,3}");
}

TEST_F(PendantTest, bringsBackWhatAScriptHadChanged) {
  EXPECT_EQ(run("TCP[\"gripper\"].Value={0,0,1,0,0,0}\r\nTCP[\"gripper\"].Mass=1\r\n"
                "Base[\"table\"].Value={9,9,9,0,0,0}"),
            ok("1"));
  robot.operate(SetTcp{"gripper", {0, 0, 160, 0, 0, 0}});
  expectValue("TCP[\"gripper\"].Value", "{0,0,160,0,0,0}");
  expectValue("TCP[\"gripper\"].Mass", "1");
  startAfresh();
  expectValue("TCP[\"gripper\"].Mass", "0");
  expectValue("Base[\"table\"].Value", "{1,2,3,0,0,0}");
}

TEST_F(PendantTest, countsFromTheNextChangeTcp) {
  EXPECT_EQ(run("ChangeTCP(\"gripper\")"), ok("1"));
  robot.operate(SetTcp{"gripper", {0, 0, 160, 0, 0, 0}});
  EXPECT_NEAR(robot.state().tcp.translation().z(), 0.15, 1e-9);
  EXPECT_EQ(run("ChangeTCP(\"gripper\")"), ok("1"));
  EXPECT_NEAR(robot.state().tcp.translation().z(), 0.16, 1e-9);
}

TEST_F(PendantTest, changesNothingThatTheProjectDoesNotHave) {
  EXPECT_EQ(refusal(SetTcp{"gripers", {}}),
            "the project has no TCP \"gripers\"; it has HandCamera, NOTOOL, big cup=2, gripper");
  EXPECT_EQ(refusal(SetLoad{"", 1, {}, {}}),
            "the project has no TCP \"\"; it has HandCamera, NOTOOL, big cup=2, gripper");
  EXPECT_EQ(refusal(SetBase{"gripper", {}}), "the project has no base \"gripper\"; it has RobotBase, table");
}

TEST_F(PendantTest, changesNothingThatIsFixed) {
  EXPECT_EQ(refusal(SetTcp{"NOTOOL", {}}), "the TCP \"NOTOOL\" is fixed and cannot be changed");
  EXPECT_THAT(refusal(SetLoad{"HandCamera", 1, {}, {}}), HasSubstr("is fixed"));
  EXPECT_THAT(refusal(SetBase{"RobotBase", {}}), HasSubstr("the base \"RobotBase\" is fixed"));
}

TEST_F(PendantTest, takesNoNumbersThatCanBeNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(SetTcp{"gripper", {0, 0, nan, 0, 0, 0}}),
            "the number nan: allowed are -100000 to 100000 [mm, deg]");
  EXPECT_EQ(refusal(SetBase{"table", {0, 0, 0, 0, 0, 100001}}),
            "the number 100001: allowed are -100000 to 100000 [mm, deg]");
  EXPECT_EQ(refusal(SetLoad{"gripper", -1, {}, {}}), "a mass of -1 kg: allowed are 0 to 1000");
  EXPECT_THAT(refusal(SetLoad{"gripper", nan, {}, {}}), HasSubstr("a mass of nan kg"));
  EXPECT_EQ(refusal(SetLoad{"gripper", 1, std::array<double, 3>{0, 0, -2}, {}}),
            "a moment of inertia of -2 kg mm^2: allowed are 0 to 1000000000");
  EXPECT_THAT(refusal(SetLoad{"gripper", 1, {}, arm::ControllerPose{0, 0, 0, nan, 0, 0}}),
              HasSubstr("the number nan"));
  expectValue("TCP[\"gripper\"].Value", "{0,0,150,0,0,0}");
  expectValue("TCP[\"gripper\"].Mass", "0");
}

TEST_F(PendantTest, isWorkedByLinesOfText) {
  EXPECT_EQ(say("set_tcp gripper=0,0,160,0,0,0"), "ok: the TCP \"gripper\" is at 0, 0, 160, 0, 0, 0");
  EXPECT_EQ(say("set_tcp big cup=2=1, 2, 3, 4, 5, 6.5"),
            "ok: the TCP \"big cup=2\" is at 1, 2, 3, 4, 5, 6.5");
  EXPECT_EQ(say("set_base table=1,2,3,0,0,-0"), "ok: the base \"table\" is at 1, 2, 3, 0, 0, 0");
  EXPECT_EQ(say("set_load gripper=2"),
            "ok: the TCP \"gripper\" weighs 2 kg, inertia 0, 0, 0 kg mm^2, centre at 0, 0, 0, 0, 0, 0");
  EXPECT_THAT(say("set_load gripper=2,7,8,9"), HasSubstr("inertia 7, 8, 9 kg mm^2"));
  EXPECT_THAT(say("set_load gripper=2,7,8,9,1,2,3,4,5,6"), HasSubstr("centre at 1, 2, 3, 4, 5, 6"));
}

TEST_F(PendantTest, refusesLinesThatSayNothingClear) {
  EXPECT_EQ(say("set_tcp"), "error: \"\": give NAME=x,y,z,rx,ry,rz [mm, deg]");
  EXPECT_EQ(say("set_tcp gripper 0,0,1,0,0,0"),
            "error: \"gripper 0,0,1,0,0,0\": give NAME=x,y,z,rx,ry,rz [mm, deg]");
  EXPECT_THAT(say("set_tcp gripper=0,0,1,0,0"), HasSubstr("give NAME=x,y,z,rx,ry,rz"));
  EXPECT_THAT(say("set_tcp gripper=0,0,1,0,0,0,2"), HasSubstr("give NAME=x,y,z,rx,ry,rz"));
  EXPECT_THAT(say("set_base table=a,b,c,d,e,f"), HasSubstr("give NAME=x,y,z,rx,ry,rz"));
  EXPECT_THAT(say("set_tcp =0,0,1,0,0,0"), HasSubstr("the project has no TCP \"\""));
  EXPECT_EQ(say("set_load gripper=1,2"),
            "error: \"gripper=1,2\": give NAME=kg, or NAME=kg,ixx,iyy,izz [kg mm^2], or these and "
            "x,y,z,rx,ry,rz [mm, deg] of the mass centre in the TCP");
  EXPECT_THAT(say("set_load gripper=heavy"), HasSubstr("give NAME=kg"));
}

}  // namespace
}  // namespace cobot_command::simulator::test
