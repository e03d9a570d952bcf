// The operator's side: pause, the way of the flow, safeguard, mode, project speed, robot errors, inputs.
#include "simulated_robot.h"
#include "streamed_items.h"
#include <gmock/gmock.h>

namespace cobot_command::simulator::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kMove = "PTP(\"JPP\",90,0,90,0,90,0,100,200,0,false)\r\nQueueTag(1)";

class OperatorTest : public ::testing::Test {
 protected:
  explicit OperatorTest(Settings settings = {}) : robot(std::move(settings)) {}

  void startMotion() {
    robot.script(client, "1", kMove);
    robot.wait(300ms);
    ASSERT_TRUE(robot.state().in_motion);
    robot.heard(client);
  }
  bool done(const OperatorAction& action) { return robot.operate(action).done; }
  std::string refusal(const OperatorAction& action) {
    const OperatorReply reply = robot.operate(action);
    EXPECT_FALSE(reply.done) << reply.text;
    return reply.text;
  }
  std::string flow() { return robot.ask(client, "00"); }
  protocol::StatusFrame statusFrame() {
    robot.heard(status);
    robot.wait(15ms);
    return framesIn(robot.heard(status)).at(0);
  }
  int streamedInt(const std::string& name) {
    return protocol::item::asInt(itemNamed(statusFrame(), name)).value();
  }
  void connectStatus() { status = robot.connect(Port::Status); }

  SimulatedRobot robot;
  ClientId client = robot.connect();
  ClientId status = 0;
};

const std::string kListening = protocol::encodeFrame("TMSTA", "00,true,Listen1");
const std::string kElsewhere = protocol::encodeFrame("TMSTA", "00,false,");

// --- Pause.
TEST_F(OperatorTest, pausesTheMotionOnItsPathAndLetsItGoOn) {
  startMotion();
  EXPECT_TRUE(done(PauseProject{}));
  robot.wait(1s);
  EXPECT_TRUE(robot.state().project_paused);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_EQ(robot.state().queued_motions, 1);
  EXPECT_TRUE(done(ResumeProject{}));
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  EXPECT_EQ(robot.heard(client), tag("01,true"));
}

TEST_F(OperatorTest, cannotPauseNorResumeNorMoveTheFlowOfAProjectThatDoesNotRun) {
  robot.stopProject();
  for (const OperatorAction& action :
       std::vector<OperatorAction>{PauseProject{}, ResumeProject{}, LeaveListenNode{}, EnterListenNode{}}) {
    EXPECT_THAT(refusal(action), HasSubstr("run it first"));
  }
}

TEST_F(OperatorTest, cannotRunAProjectWhileTheEmergencyStopIsPressed) {
  robot.setEmergencyStop(true);
  EXPECT_THAT(refusal(RunProject{}), HasSubstr("release the emergency stop"));
}

// --- The flow.
TEST_F(OperatorTest, letsTheFlowGoElsewhereAndStayThere) {
  EXPECT_TRUE(done(LeaveListenNode{}));
  EXPECT_EQ(flow(), kElsewhere);
  robot.wait(1h);
  EXPECT_EQ(flow(), kElsewhere);
  robot.script(client, "1", kMove);
  EXPECT_EQ(robot.heard(client), "$CPERR,2,F1,*3F\r\n");
}

TEST_F(OperatorTest, letsTheFlowComeBackWithTheEntryMessage) {
  done(LeaveListenNode{});
  EXPECT_TRUE(done(EnterListenNode{}));
  EXPECT_EQ(robot.heard(client), entered());
  EXPECT_EQ(flow(), kListening);
}

TEST_F(OperatorTest, letsTheFlowLeaveOnlyWhenTheQueuedMotionsAreDone) {
  startMotion();
  EXPECT_THAT(robot.operate(LeaveListenNode{}).text, HasSubstr("when the queued motions are done"));
  EXPECT_EQ(flow(), kElsewhere);
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  EXPECT_EQ(flow(), kElsewhere);
}

TEST_F(OperatorTest, mayChangeItsMindWhileTheFlowLeaves) {
  startMotion();
  done(LeaveListenNode{});
  done(EnterListenNode{});
  EXPECT_EQ(flow(), kElsewhere);
  robot.waitUntilIdle();
  EXPECT_EQ(flow(), kListening);
}

TEST_F(OperatorTest, leavesTheLoopOfTheProjectAsItWasOnceTheFlowIsBack) {
  done(EnterListenNode{});  // it is there already
  done(LeaveListenNode{});
  done(EnterListenNode{});
  robot.heard(client);
  robot.script(client, "1", "ScriptExit()");
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.wait(99ms);
  EXPECT_EQ(flow(), kElsewhere);
  robot.wait(1ms);
  EXPECT_EQ(robot.heard(client), entered()) << "after the usual 100 ms";
}

TEST_F(OperatorTest, endsTheScriptThatWaitsAndRefusesThoseBehindItWhenTheFlowLeaves) {
  robot.script(client, "1", std::string(kMove) + "\r\nWaitQueueTag(1)");
  robot.script(client, "2", kMove);
  done(LeaveListenNode{});
  EXPECT_EQ(robot.heard(client), ok("1") + "$CPERR,2,F1,*3F\r\n");
}

// --- The safeguard.
TEST_F(OperatorTest, holdsTheArmOnItsPathWithTheSafeguard) {
  connectStatus();
  startMotion();
  EXPECT_TRUE(done(SetSafeguard{true}));
  robot.wait(200ms);
  const double reached = robot.joints()[0];
  robot.wait(1s);
  EXPECT_EQ(robot.joints()[0], reached);
  EXPECT_TRUE(robot.state().safeguard);
  EXPECT_TRUE(flag(statusFrame(), "Safeguard_A"));
  EXPECT_FALSE(flag(statusFrame(), "Project_Pause"));
}

TEST_F(OperatorTest, letsTheArmGoOnWhenTheSafeguardIsClosedAgain) {
  startMotion();
  done(SetSafeguard{true});
  robot.wait(1s);
  done(SetSafeguard{false});
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  EXPECT_EQ(robot.heard(client), tag("01,true"));
}

TEST_F(OperatorTest, needsBothResumeAndAClosedSafeguardWhenBothHoldTheArm) {
  startMotion();
  done(SetSafeguard{true});
  done(PauseProject{});
  robot.wait(1s);
  const double reached = robot.joints()[0];
  EXPECT_THAT(robot.operate(ResumeProject{}).text, HasSubstr("safeguard"));
  robot.wait(1s);
  EXPECT_EQ(robot.joints()[0], reached);
  done(PauseProject{});
  done(SetSafeguard{false});
  robot.wait(1s);
  EXPECT_EQ(robot.joints()[0], reached);
  done(ResumeProject{});
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
}

TEST_F(OperatorTest, keepsAMotionThatComesBehindTheOpenSafeguardWaiting) {
  done(SetSafeguard{true});
  robot.script(client, "1", kMove);
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.wait(10s);
  EXPECT_EQ(robot.joints()[0], 0.0);
  done(SetSafeguard{false});
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
}

class ManualResetTest : public OperatorTest {
 protected:
  static Settings settings() {
    Settings settings;
    settings.safeguard_resets_itself = false;
    return settings;
  }
  ManualResetTest() : OperatorTest(settings()) {}
};

TEST_F(ManualResetTest, leavesTheProjectPausedWhenTheSafeguardIsClosed) {
  startMotion();
  done(SetSafeguard{true});
  robot.wait(1s);
  const double reached = robot.joints()[0];
  done(SetSafeguard{false});
  robot.wait(1s);
  EXPECT_EQ(robot.joints()[0], reached);
  EXPECT_TRUE(robot.state().project_paused);
  done(ResumeProject{});
  robot.waitUntilIdle();
  EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
}

// --- Mode and speed.
TEST_F(OperatorTest, showsManualAndAutomaticMode) {
  connectStatus();
  EXPECT_EQ(streamedInt("MA_Mode"), 1);
  EXPECT_EQ(streamedInt("Robot_Light"), 4) << "flashing blue";
  done(SetOperatingMode{OperatingMode::Manual});
  EXPECT_EQ(streamedInt("MA_Mode"), 2);
  EXPECT_EQ(streamedInt("Robot_Light"), 6) << "flashing green";
}

TEST_F(OperatorTest, slowsTheMotionsThatStartFromNowOn) {
  connectStatus();
  EXPECT_TRUE(done(SetProjectSpeed{50}));
  EXPECT_EQ(streamedInt("Project_Speed"), 50);
  robot.disconnect(status, Port::Status);
  const auto duration = [&](const std::string& target) {
    const Instant start = robot.now();
    robot.script(client, "1", "PTP(\"JPP\"," + target + ",0,90,0,90,0,100,200,0,false)");
    robot.waitUntilIdle();
    return toSeconds(robot.now() - start);
  };
  const double halved = duration("90");
  done(SetProjectSpeed{100});
  const double full = duration("0");
  // 90 degrees at 180 deg/s and 200 ms to top speed, and at half of that speed.
  EXPECT_NEAR(full, 0.5 + 0.2, 1e-3);
  EXPECT_NEAR(halved, 1.0 + 0.2, 1e-3);
}

TEST_F(OperatorTest, refusesAProjectSpeedThatThePendantDoesNotHave) {
  for (const int percent : {0, -5, 4, 7, 105}) {
    EXPECT_THAT(refusal(SetProjectSpeed{percent}), HasSubstr("5 to 100 in steps of 5"));
  }
  EXPECT_EQ(robot.state().project_speed_percent, 100);
}

// --- Robot errors.
TEST_F(OperatorTest, bringsTheArmToRestAndReportsItsTagsFalseWhenTheRobotFails) {
  startMotion();
  EXPECT_TRUE(done(RaiseError{0x14058, "joint 3"}));
  EXPECT_EQ(robot.heard(client), tag("01,false"));
  EXPECT_EQ(robot.state().error_code, 0x14058);
  EXPECT_EQ(robot.state().error_text, "joint 3");
  EXPECT_TRUE(robot.state().in_motion) << "it slows down on its path";
  robot.wait(200ms);
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_LT(robot.joints()[0], 89.0);
}

TEST_F(OperatorTest, letsNoMotionBeMadeUntilTheErrorIsCleared) {
  done(RaiseError{0x14058, "joint 3"});
  robot.script(client, "1", kMove);
  EXPECT_EQ(robot.heard(client), ok("1") + tag("01,false"));
  EXPECT_TRUE(robot.state().error);
  EXPECT_TRUE(done(ClearError{}));
  EXPECT_FALSE(robot.state().error);
  robot.script(client, "2", kMove);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), ok("2") + tag("01,true"));
}

TEST_F(OperatorTest, clearsTheErrorByRunningTheProjectAgain) {
  done(RaiseError{1, ""});
  robot.stopProject();
  robot.runProject();
  EXPECT_FALSE(robot.state().error);
}

TEST_F(OperatorTest, cannotRaiseAnErrorWithoutACode) {
  EXPECT_THAT(refusal(RaiseError{0, "none"}), HasSubstr("give another"));
  EXPECT_FALSE(robot.state().error);
}

class StoppedByErrorTest : public OperatorTest {
 protected:
  static Settings settings() {
    Settings settings;
    settings.on_motion_error = MotionErrorPolicy::StopProject;
    return settings;
  }
  StoppedByErrorTest() : OperatorTest(settings()) {}
};

TEST_F(StoppedByErrorTest, stopsTheProjectWhenTheRobotFailsIfThatIsThePolicy) {
  startMotion();
  robot.events();
  done(RaiseError{1, ""});
  EXPECT_EQ(robot.heard(client), tag("01,false"));
  EXPECT_THAT(robot.events(), ElementsAre("x1", "-script"));
}

// --- What was held when the project ended.
class RunAgainTest : public StoppedByErrorTest {
 protected:
  void holdMotion(const OperatorAction& action) {
    startMotion();
    done(action);
    robot.wait(1s);
    ASSERT_FALSE(robot.state().in_motion);
    ASSERT_EQ(robot.state().queued_motions, 1);
  }
  /// And moves, as if nothing had been.
  void runAgain() {
    done(RunProject{});
    EXPECT_FALSE(robot.state().project_paused);
    client = robot.connect();
    robot.script(client, "2", kMove);
    robot.wait(300ms);
    EXPECT_TRUE(robot.state().in_motion);
    robot.waitUntilIdle();
    EXPECT_NEAR(robot.joints()[0], 90.0, 1e-9);
  }
};

TEST_F(RunAgainTest, movesAfterAStopOfThePausedProject) {
  holdMotion(PauseProject{});
  done(StopProject{});
  runAgain();
}

TEST_F(RunAgainTest, movesAfterAStopWhileThePausedArmStillSlowsDown) {
  startMotion();
  done(PauseProject{});
  robot.wait(20ms);
  done(StopProject{});
  runAgain();
}

TEST_F(RunAgainTest, movesAfterAnEmergencyStopOfThePausedProject) {
  holdMotion(PauseProject{});
  done(SetEmergencyStop{true});
  done(SetEmergencyStop{false});
  runAgain();
}

TEST_F(RunAgainTest, movesAfterAnErrorThatStopsThePausedProject) {
  holdMotion(PauseProject{});
  done(RaiseError{1, ""});
  runAgain();
}

TEST_F(RunAgainTest, movesAfterAPauseThatCameBehindTheStopOfTheQueue) {
  startMotion();
  robot.script(client, "8", "StopAndClearBuffer()");
  done(PauseProject{});
  robot.wait(1s);
  done(StopProject{});
  runAgain();
}

TEST_F(RunAgainTest, movesOnceTheSafeguardIsClosedToo) {
  holdMotion(SetSafeguard{true});
  done(StopProject{});
  done(SetSafeguard{false});
  runAgain();
}

// --- Inputs.
TEST_F(OperatorTest, setsInputsThatTheStreamShows) {
  connectStatus();
  EXPECT_TRUE(done(SetInput{script::IoModule::EndModule, 1, true}));
  EXPECT_TRUE(done(SetInput{script::IoModule::ControlBox, 7, true}));
  auto frame = statusFrame();
  EXPECT_EQ(itemNamed(frame, "End_DI1").value, "\x01");
  EXPECT_EQ(itemNamed(frame, "Ctrl_DI7").value, "\x01");
  EXPECT_TRUE(done(SetInput{script::IoModule::EndModule, 1, false}));
  EXPECT_EQ(itemNamed(statusFrame(), "End_DI1").value, std::string(1, '\0'));
}

TEST_F(OperatorTest, refusesInputsThatAreNotThere) {
  EXPECT_THAT(refusal(SetInput{script::IoModule::EndModule, 4, true}), HasSubstr("0 to 3"));
  EXPECT_THAT(refusal(SetInput{script::IoModule::ControlBox, -1, true}), HasSubstr("0 to 15"));
}

TEST_F(OperatorTest, findsEachActionInTheLog) {
  done(SetSafeguard{true});
  EXPECT_EQ(robot.log().back().text, "operator: the safeguard is open");
}

}  // namespace
}  // namespace cobot_command::simulator::test
