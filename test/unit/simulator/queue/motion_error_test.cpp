// A motion that cannot be made never half-happens: robot error, empty queue, open tags reported false.
#include "simulated_robot.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kGood = "PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)";
constexpr const char* kOutOfReach = "PTP(\"CPP\",2000,0,300,180,0,90,10,200,0,false)";

class MotionErrorTest : public ::testing::Test {
 protected:
  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(MotionErrorTest, anUnreachableTargetIsAcceptedAndThenFails) {
  const arm::JointVector before = robot.state().joints;
  robot.script(client, "1", std::string(kOutOfReach) + "\r\nQueueTag(3)");
  EXPECT_EQ(robot.heard(client), ok("1") + tag("03,false"));
  const RobotState state = robot.state();
  EXPECT_TRUE(state.error);
  EXPECT_EQ(state.error_code, 0x01);
  EXPECT_THAT(state.error_text, HasSubstr("UNREACHABLE"));
  EXPECT_FALSE(state.in_motion);
  EXPECT_EQ(state.joints, before);
  EXPECT_EQ(robot.ask(client, "01,03"), tag("03,false"));
}

TEST_F(MotionErrorTest, anUnreachablePlaceBetweenReachableEndsHasACodeOfItsOwn) {
  robot.script(client, "1",
               "PTP(\"CPP\",417.5,-60,461.05,180,0,90,100,200,0,false)\r\n"
               "Line(\"CAP\",-382.5,-60,461.05,180,0,90,500,200,0,false)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.state().error_code, 0x12);
}

TEST_F(MotionErrorTest, everythingBehindTheMotionIsGivenUp) {
  robot.script(client, "1",
               std::string(kGood) + "\r\nQueueTag(1)\r\n" + kOutOfReach + "\r\nQueueTag(2)\r\n" + kGood +
                   "\r\nQueueTag(3)");
  EXPECT_FALSE(robot.state().error) << "the motion is planned when its start is known";
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,true") + tag("02,false") + tag("03,false"));
  EXPECT_TRUE(robot.state().error);
  EXPECT_EQ(robot.state().queued_motions, 0);
}

TEST_F(MotionErrorTest, aTagThatComesAfterTheErrorIsReportedFalseToo) {
  robot.script(client, "1", kOutOfReach);
  robot.script(client, "2", "QueueTag(3)");
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2") + tag("03,false"));
}

TEST_F(MotionErrorTest, aScriptThatWaitsEndsAndBufferedOnesAreDropped) {
  robot.script(client, "1", std::string(kGood) + "\r\n" + kOutOfReach + "\r\nQueueTag(1,1)\r\n" + kGood);
  robot.script(client, "2", kGood);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("01,false") + ok("1"));
  EXPECT_FALSE(robot.state().in_motion);
}

TEST_F(MotionErrorTest, theNextMotionClearsTheError) {
  robot.script(client, "1", kOutOfReach);
  EXPECT_TRUE(robot.state().error);
  robot.script(client, "2", std::string(kGood) + "\r\nQueueTag(1)");
  EXPECT_FALSE(robot.state().error);
  EXPECT_EQ(robot.state().error_code, 0);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + ok("2") + tag("01,true"));
}

TEST_F(MotionErrorTest, aProjectThatRunsAgainHasNoError) {
  robot.script(client, "1", kOutOfReach);
  robot.stopProject();
  EXPECT_TRUE(robot.state().error);
  robot.runProject();
  EXPECT_FALSE(robot.state().error);
}

TEST_F(MotionErrorTest, stopsTheProjectWhenItIsSetToDoSo) {
  Settings settings;
  settings.on_motion_error = MotionErrorPolicy::StopProject;
  SimulatedRobot strict(settings);
  strict.events();
  const ClientId one = strict.connect();
  strict.script(one, "1", std::string(kOutOfReach) + "\r\nQueueTag(1)");
  EXPECT_EQ(strict.heard(one), ok("1") + tag("01,false"));
  EXPECT_THAT(strict.events(), ElementsAre("x1", "-script"));
  EXPECT_TRUE(strict.state().error);
  EXPECT_FALSE(strict.state().project_running);
}

TEST(Payload, isCarriedToItsFullRating) {
  SimulatedRobot robot;  // a TM5-700: 6 kg
  robot.script(robot.connect(), "1", "ChangeTCP(0,0,0,0,0,0,4)\r\nChangeLoad(2)\r\n" + std::string(kGood));
  robot.waitUntilIdle();
  EXPECT_FALSE(robot.state().error);
}

TEST(Payload, isNotAskedForWhereTheSettingSaysSo) {
  Settings settings;
  settings.checks_payload = false;
  SimulatedRobot robot(settings);
  robot.script(robot.connect(), "1", "ChangeLoad(20)\r\n" + std::string(kGood));
  robot.waitUntilIdle();
  EXPECT_FALSE(robot.state().error);
}

/// What a widespread off-line programming tool sends in every motion.
constexpr const char* kZeroRamps =
    "PTP(\"JPP\",5,0,90,0,90,0,10,0,0,false)\r\n"
    "Line(\"CAP\",417.5,-60,461.05,180,0,90,100,0,0,false)\r\n"
    "Circle(\"CAP\",427.5,-40,461.05,180,0,90,417.5,-20,461.05,180,0,90,100,0,0,0,false)";

TEST(ZeroRamp, isTakenAsTheShortestThatTheArmAllows) {
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  robot.script(client, "1", std::string(kZeroRamps) + "\r\nQueueTag(1)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,true"));
  EXPECT_FALSE(robot.state().error) << robot.state().error_text;
}

TEST(ZeroRamp, isARobotErrorWhereTheSettingSaysSo) {
  Settings settings;
  settings.accept_zero_ramp = false;
  SimulatedRobot robot(settings);
  const ClientId client = robot.connect();
  robot.script(client, "1", std::string(kZeroRamps) + "\r\nQueueTag(1)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,false"));
  EXPECT_EQ(robot.state().error_code, 0x21);
  EXPECT_THAT(robot.state().error_text, HasSubstr("accept_zero_ramp"));
}

struct Case {
  const char* script;
  int code;
  const char* text;
};

void PrintTo(const Case& test_case, std::ostream* out) {
  *out << test_case.script;
}

class ErrorCodeTest : public ::testing::TestWithParam<Case> {};

TEST_P(ErrorCodeTest, namesTheReason) {
  SimulatedRobot robot;
  const ClientId client = robot.connect();
  robot.script(client, "1", std::string(GetParam().script) + "\r\nQueueTag(1)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,false"));
  EXPECT_EQ(robot.state().error_code, GetParam().code);
  EXPECT_THAT(robot.state().error_text, HasSubstr(GetParam().text));
}

// The start is 417.5, -122.3, 361.05, 180, 0, 90 in the posture 0, 0, 90, 0, 90, 0 of a TM5-700.
INSTANTIATE_TEST_SUITE_P(
    Motions, ErrorCodeTest,
    ::testing::Values(
        Case{"PTP(\"CPP\",2000,0,300,180,0,90,10,200,0,false)", 0x01, "UNREACHABLE"},
        Case{"Line(\"CAP\",2000,0,300,180,0,90,100,200,0,false)", 0x01, "UNREACHABLE"},
        Case{"PTP(\"CPP\",417.5,-122.3,361.05,180,0,90,10,200,0,false,0,2,9)", 0x14058, "POSE_BITS"},
        Case{"PTP(\"JPP\",0,0,170,0,90,0,10,200,0,false)", 0x1405A, "JOINT_LIMIT"},
        Case{"Move_PTP(\"JPP\",0,0,100,0,0,0,10,200,0,false)", 0x1405A, "JOINT_LIMIT"},
        Case{"ChangeLoad(6.1)\r\nPTP(\"JPP\",0,0,80,0,90,0,10,200,0,false)", 0x22, "6.1 kg"},
        Case{"ChangeLoad(-1)\r\nPTP(\"JPP\",0,0,80,0,90,0,10,200,0,false)", 0x22, "OVERLOAD"},
        Case{"ChangeTCP(0,0,0,0,0,0,4)\r\nChangeLoad(2.1)\r\nMove_Line(\"CAP\",0,0,20,0,0,0,100,200,0,false)",
             0x22, "OVERLOAD"},
        Case{"Move_Line(\"CAP\",0,0,40,0,0,0,100,200,50,false)\r\nChangeLoad(7)\r\n"
             "Move_Line(\"CAP\",0,40,0,0,0,0,100,200,0,false)",
             0x22, "OVERLOAD"},
        Case{"PTP(\"JPP\",0,0,80,0,90,0,0,200,0,false)", 0x21, "BAD_PARAMETER"},
        Case{"PTP(\"JPP\",0,0,80,0,90,0,-10,200,0,false)", 0x21, "BAD_PARAMETER"},
        Case{"PTP(\"JPP\",0,0,80,0,90,0,101,200,0,false)", 0x21, "BAD_PARAMETER"},
        Case{"Line(\"CAP\",300,200,361.05,180,0,90,4500,50,0,false)", 0x21, "JOINT_SPEED"},
        Case{"Circle(\"CAP\",417.5,-122.3,361.05,180,0,90,450,0,361.05,180,0,90,100,200,0,0,false)", 0x15,
             "DEGENERATE_CIRCLE"}));

}  // namespace
}  // namespace cobot_command::simulator::test
