// Scripts: checked as a whole, executed in order, held by lines that wait.
#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

constexpr const char* kMove = "PTP(\"JPP\",10,0,90,0,90,0,100,200,0,false)";
constexpr const char* kMoveBack = "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)";
// 10 degrees of joint 1 at 180 deg/s, reached in 200 ms: a triangle of 2 sqrt(10 / 900) s.
constexpr double kMoveSeconds = 0.210818510677892;

std::string lines(std::initializer_list<std::string> of) {
  std::string script;
  for (const std::string& line : of) script += (script.empty() ? "" : "\r\n") + line;
  return script;
}

class ScriptTest : public ::testing::Test {
 protected:
  SimulatedRobot robot;
  ClientId client = robot.connect();
};

TEST_F(ScriptTest, isAcceptedAtOnceWhenItOnlyQueues) {
  robot.script(client, "1", lines({kMove, "QueueTag(1)"}));
  EXPECT_EQ(robot.heard(client), ok("1"));
  EXPECT_TRUE(robot.state().in_motion);
}

TEST_F(ScriptTest, reportsTheTagWhenTheArmStandsAtTheTarget) {
  robot.script(client, "1", lines({kMove, "QueueTag(8,0)"}));
  robot.heard(client);
  robot.wait(fromSeconds(kMoveSeconds) - 1us);
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_EQ(robot.ask(client, "01,08"), tag("08,false"));
  robot.wait(2us);
  EXPECT_EQ(robot.heard(client), tag("08,true"));
  EXPECT_EQ(robot.ask(client, "01,08"), tag("08,true"));
  EXPECT_NEAR(robot.joints()[0], 10.0, 1e-9);
  EXPECT_FALSE(robot.state().in_motion);
}

TEST_F(ScriptTest, completesATagAtOnceWhenNothingIsQueued) {
  robot.script(client, "1", "QueueTag(8)");
  EXPECT_EQ(robot.heard(client), ok("1") + tag("08,true"));
}

TEST_F(ScriptTest, withAnErrorNamesTheLinesAndExecutesNothing) {
  robot.script(client, "7", lines({kMove, "Bogus()", "QueueTag(1)", "PTP(\"XYZ\",1)", kMove}));
  EXPECT_EQ(robot.heard(client), error("7", "2;4"));
  EXPECT_FALSE(robot.state().in_motion);
  EXPECT_EQ(robot.state().queued_motions, 0);
}

TEST_F(ScriptTest, namesABaseOrToolThatTheProjectDoesNotKnow) {
  robot.script(client, "7",
               lines({"ChangeBase(\"RobotBase\")", "ChangeBase(\"Table\")", "ChangeTCP(\"Claw\")"}));
  EXPECT_EQ(robot.heard(client), error("7", "2;3"));
}

TEST_F(ScriptTest, namesATagThatIsNotOneToFifteen) {
  robot.script(client, "7", lines({"QueueTag(1)", "QueueTag(16)", "QueueTag(0)"}));
  EXPECT_EQ(robot.heard(client), error("7", "2;3"));
}

TEST_F(ScriptTest, countsEmptyLinesAndTakesALineBreakAtTheEnd) {
  robot.script(client, "1", "\r\nBogus()\r\n");
  EXPECT_EQ(robot.heard(client), error("1", "2"));
  robot.script(client, "2", "\r\nQueueTag(1)\r\n");
  EXPECT_EQ(robot.heard(client), ok("2") + tag("01,true"));
}

TEST_F(ScriptTest, holdsItsReplyWhileItWaitsForATag) {
  robot.script(client, "1", lines({kMove, "QueueTag(8,1)"}));
  EXPECT_EQ(robot.heard(client), "");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("08,true") + ok("1"));
}

TEST_F(ScriptTest, goesOnBehindTheTagThatItWaitedFor) {
  robot.script(client, "1", lines({kMove, "QueueTag(1,1)", kMoveBack, "QueueTag(2,1)"}));
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("01,true") + tag("02,true") + ok("1"));
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), 2 * kMoveSeconds, 1e-8);
}

TEST_F(ScriptTest, buffersTheScriptsBehindOneThatWaits) {
  robot.script(client, "1", lines({kMove, "QueueTag(1,1)"}));
  robot.script(client, "2", "Bogus()");
  robot.script(client, "3", "QueueTag(2)");
  EXPECT_EQ(robot.heard(client), "");
  EXPECT_EQ(robot.ask(client, "00"), protocol::encodeFrame("TMSTA", "00,true,Listen1"));
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("01,true") + ok("1") + error("2", "1") + ok("3") + tag("02,true"));
}

TEST_F(ScriptTest, ofSeveralClientsRunInOrderOfArrivalAndAreAnsweredToTheirSenders) {
  const ClientId other = robot.connect();
  robot.script(client, "1", lines({kMove, "QueueTag(1,1)"}));
  robot.script(other, "1", "QueueTag(2,1)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("01,true") + ok("1") + tag("02,true"));
  EXPECT_EQ(robot.heard(other), tag("01,true") + tag("02,true") + ok("1"));
}

TEST_F(ScriptTest, waitsForATagThatAnEarlierScriptQueued) {
  robot.script(client, "1", lines({kMove, "QueueTag(4)"}));
  robot.script(client, "2", "WaitQueueTag(4)");
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("04,true") + ok("2"));
}

TEST_F(ScriptTest, waitsForATagNoLongerThanItsTimeout) {
  robot.script(client, "1", lines({kMove, "QueueTag(4)", "WaitQueueTag(4,50)"}));
  robot.wait(49ms);
  EXPECT_EQ(robot.heard(client), "");
  robot.wait(1ms);
  EXPECT_EQ(robot.heard(client), ok("1"));
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("04,true"));
}

TEST_F(ScriptTest, doesNotWaitForATagThatNobodyKnows) {
  robot.script(client, "1", "WaitQueueTag(4)");
  EXPECT_EQ(robot.heard(client), ok("1"));
}

TEST_F(ScriptTest, forgetsAllButTheLastFourTagsButCompletesThem) {
  robot.script(client, "1",
               lines({kMove, "QueueTag(1)", "QueueTag(2)", "QueueTag(3)", "QueueTag(4)", "QueueTag(5)"}));
  EXPECT_EQ(robot.ask(client, "01,01"), tag("01,none"));
  EXPECT_EQ(robot.ask(client, "01,02"), tag("02,false"));
  robot.heard(client);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client),
            tag("01,true") + tag("02,true") + tag("03,true") + tag("04,true") + tag("05,true"));
}

TEST_F(ScriptTest, runsOnWhenItsClientGoesAway) {
  const ClientId other = robot.connect();
  robot.script(client, "1", lines({kMove, "QueueTag(1,1)", kMoveBack, "QueueTag(2,1)"}));
  robot.disconnect(client);
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(other), tag("01,true") + tag("02,true"));
  EXPECT_EQ(robot.heard(client), "");
}

TEST_F(ScriptTest, leavesTheNodeWhenTheQueuedMotionIsDone) {
  robot.script(client, "1", lines({kMove, "ScriptExit()", "Bogus2", kMoveBack}));
  EXPECT_EQ(robot.heard(client), error("1", "3"));
  robot.script(client, "2", lines({kMove, "ScriptExit()", kMoveBack}));
  EXPECT_EQ(robot.heard(client), ok("2"));
  robot.script(client, "3", "QueueTag(1)");
  EXPECT_EQ(robot.heard(client), "$CPERR,2,F1,*3F\r\n");
  robot.wait(fromSeconds(kMoveSeconds) + 99ms);
  EXPECT_NEAR(robot.joints()[0], 10.0, 1e-9);
  EXPECT_EQ(robot.heard(client), "");
  robot.wait(1ms);
  EXPECT_EQ(robot.heard(client), entered());
  EXPECT_TRUE(robot.state().listening);
}

TEST_F(ScriptTest, leavesTheNodeAtOnceWhenNoMotionIsQueued) {
  robot.script(client, "1", lines({"ChangeLoad(1)", "ScriptExit()"}));
  robot.wait(100ms);
  EXPECT_EQ(robot.heard(client), ok("1") + entered());
}

TEST_F(ScriptTest, isRefusedWhenItWasBufferedBehindAScriptExit) {
  robot.script(client, "1", lines({kMove, "QueueTag(1,1)", "ScriptExit()"}));
  robot.script(client, "2", "QueueTag(2)");
  robot.waitUntilIdle();
  EXPECT_EQ(robot.heard(client), tag("01,true") + ok("1") + "$CPERR,2,F1,*3F\r\n" + entered());
}

TEST_F(ScriptTest, neverComesBackWhenTheProjectDoesNotLoop) {
  Settings settings;
  settings.reentry_delay.reset();
  SimulatedRobot once(settings);
  const ClientId one = once.connect();
  once.script(one, "1", "ScriptExit()");
  once.wait(1h);
  EXPECT_EQ(once.heard(one), ok("1"));
  EXPECT_FALSE(once.state().listening);
  EXPECT_TRUE(once.state().project_running);
}

}  // namespace
}  // namespace cobot_command::simulator::test
