// The operator's side: project start and stop, emergency stop.
#include "simulated_robot.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr const char* kMove = "PTP(\"JPP\",90,0,90,0,90,0,100,200,0,false)";

TEST(Project, opensBothPortsWhenItRunsFromTheStart) {
  SimulatedRobot robot;
  EXPECT_THAT(robot.events(), ElementsAre("+status", "+script"));
  EXPECT_TRUE(robot.state().project_running);
  EXPECT_TRUE(robot.state().listening);
}

TEST(Project, keepsTheScriptPortClosedUntilItRuns) {
  Settings settings;
  settings.project_running = false;
  SimulatedRobot robot(settings);
  EXPECT_THAT(robot.events(), ElementsAre("+status"));
  EXPECT_FALSE(robot.state().project_running);
  robot.connect();
  EXPECT_THAT(robot.events(), ElementsAre("x1"));
  robot.runProject();
  EXPECT_THAT(robot.events(), ElementsAre("+script"));
  const ClientId client = robot.connect();
  EXPECT_EQ(robot.ask(client, "00"), protocol::encodeFrame("TMSTA", "00,true,Listen1"));
}

TEST(Project, stopsTheArmAndClosesTheScriptPort) {
  SimulatedRobot robot;
  robot.events();
  const ClientId client = robot.connect(), status = robot.connect(Port::Status);
  robot.script(client, "1", kMove);
  robot.wait(300ms);
  robot.stopProject();
  EXPECT_THAT(robot.events(), ElementsAre("x1", "-script"));
  robot.wait(200ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_LT(robot.joints()[0], 89.0);
  EXPECT_EQ(robot.state().queued_motions, 0);
  EXPECT_FALSE(robot.state().project_running);
  EXPECT_NE(robot.heard(status), "") << "the status stream goes on without a project";
}

TEST(Project, startsAfreshWhenItRunsAgain) {
  SimulatedRobot robot;
  ClientId client = robot.connect();
  robot.script(client, "1",
               "ChangeBase(1,2,3,0,0,0)\r\nChangeTCP(0,0,100,0,0,0,2)\r\nPause()\r\nQueueTag(5)");
  EXPECT_TRUE(robot.state().project_paused);
  EXPECT_EQ(robot.state().base_name, "");
  EXPECT_EQ(robot.state().tcp_mass, 2.0);
  robot.stopProject();
  EXPECT_FALSE(robot.state().project_paused);
  robot.runProject();
  client = robot.connect();
  EXPECT_EQ(robot.state().base_name, "RobotBase");
  EXPECT_EQ(robot.state().tcp_name, "NOTOOL");
  EXPECT_TRUE(robot.state().base.isApprox(arm::Pose::Identity()));
  EXPECT_FALSE(robot.state().project_paused);
  EXPECT_EQ(robot.ask(client, "01,05"), tag("05,none"));
}

TEST(Project, runsAndStopsOnlyOnce) {
  SimulatedRobot robot;
  robot.events();
  robot.runProject();
  EXPECT_THAT(robot.events(), IsEmpty());
  robot.stopProject();
  robot.events();
  robot.stopProject();
  EXPECT_THAT(robot.events(), IsEmpty());
}

TEST(EmergencyStop, standsAtOnceAndStopsTheProject) {
  SimulatedRobot robot;
  robot.events();
  const ClientId client = robot.connect();
  robot.script(client, "1", kMove);
  robot.wait(300ms);
  const double reached = robot.joints()[0];
  robot.setEmergencyStop(true);
  EXPECT_THAT(robot.events(), ElementsAre("x1", "-script"));
  EXPECT_TRUE(robot.state().emergency_stop);
  EXPECT_TRUE(robot.state().velocities.isZero());
  robot.wait(1s);
  EXPECT_EQ(robot.joints()[0], reached);
}

TEST(EmergencyStop, keepsTheProjectStoppedUntilItIsReleasedAndRunAgain) {
  SimulatedRobot robot;
  robot.setEmergencyStop(true);
  robot.events();
  robot.runProject();
  EXPECT_THAT(robot.events(), IsEmpty());
  robot.setEmergencyStop(false);
  EXPECT_FALSE(robot.state().emergency_stop);
  EXPECT_FALSE(robot.state().project_running);
  robot.runProject();
  EXPECT_THAT(robot.events(), ElementsAre("+script"));
}

TEST(Project, forgetsTheRestOfAMotionThatAnEmergencyStopEnded) {
  SimulatedRobot robot;
  robot.script(robot.connect(), "1", kMove);
  robot.wait(300ms);
  robot.setEmergencyStop(true);
  const double reached = robot.joints()[0];
  robot.setEmergencyStop(false);
  robot.runProject();
  robot.wait(5s);
  EXPECT_EQ(robot.joints()[0], reached);
}

}  // namespace
}  // namespace cobot_command::simulator::test
