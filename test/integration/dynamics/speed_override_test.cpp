// The speed override: for what is planned and sent from then on, and at 0 a pause.
#include <cmath>
#include <limits>

#include "dynamics_cell.h"

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

using SpeedOverrides = DynamicsCell;

TEST_F(SpeedOverrides, areAHundredPercentAtTheStart) {
  EXPECT_EQ(cell.group().speed_override, 100);
  EXPECT_EQ(cell.group().effective_speed, 100);
  const GoalId move = cell.submit(turnTo(162));
  EXPECT_NEAR(planned(move), 2.0, 1e-3);
}

/// Oracle 20.
TEST_F(SpeedOverrides, slowTheNextMoveAndNotItsRamps) {
  const auto answer = cell.setSpeedOverride(50);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->success);
  EXPECT_EQ(answer->effective, 50);
  EXPECT_THAT(answer->message, HasSubstr("next motion"));
  const GoalId move = cell.submit(turnTo(162));
  EXPECT_NEAR(topSpeedUntilEndOf(move), 45, 0.1);
  expectDone(move);
  EXPECT_NEAR(planned(move), 3.8, 1e-3);
  EXPECT_NEAR(toSeconds(*cell.endOf(move).actual), 3.8, 0.05);
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",25,200,0,"));
}

/// Oracle 20.
TEST_F(SpeedOverrides, areRefusedOutOfTheirRangeAndStayAsTheyWere) {
  cell.setSpeedOverride(40);
  for (const double percent :
       {101.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const auto answer = cell.setSpeedOverride(percent);
    ASSERT_TRUE(answer);
    EXPECT_FALSE(answer->success);
    EXPECT_EQ(answer->error_id, 0x8D23);
    EXPECT_THAT(answer->message, HasSubstr("allowed: 0 to 100"));
    EXPECT_EQ(answer->effective, 40);
  }
  EXPECT_EQ(cell.group().speed_override, 40);
}

TEST_F(SpeedOverrides, leaveWhatIsUnderWayAsItIs) {
  const GoalId first = cell.submit(turnTo(90));
  cell.pass(300ms);
  const auto answer = cell.setSpeedOverride(50);
  EXPECT_EQ(answer->effective, 100) << "of what moves the robot";
  EXPECT_THAT(answer->message, HasSubstr("motions at the controller keep their speed"));
  EXPECT_EQ(cell.group().effective_speed, 100);
  const GoalId second = cell.submit(turnTo(0));
  EXPECT_NEAR(planned(first), 1.2, 1e-3);
  ASSERT_TRUE(cell.passUntil([&] { return cell.accepted(second); }));
  cell.pass(50ms);
  EXPECT_EQ(cell.group().effective_speed, 50);
  EXPECT_NEAR(planned(second), 2.2, 1e-3);
}

TEST_F(SpeedOverrides, countForAGoalThatWaitsAlready) {
  const GoalId first = cell.submit(turnTo(90));
  const GoalId second = cell.submit(turnTo(0));
  cell.setSpeedOverride(50);
  expectDone(first);
  expectDone(second);
  EXPECT_NEAR(planned(second), 2.2, 1e-3);
}

TEST_F(SpeedOverrides, countForAGoalThatIsBeingPlanned) {
  CoreAndRobot slow("tm5-900", {}, {}, 100ms);
  slow.connect();
  const GoalId move = slow.submit(turnTo(90));
  slow.pass(50ms);
  slow.setSpeedOverride(50);
  EXPECT_NEAR(toSeconds(*slow.endOf(move).planned), 2.2, 1e-3);
}

TEST_F(SpeedOverrides, countForChecks) {
  cell.setSpeedOverride(50);
  MoveAbsoluteGoal goal = turnTo(90);
  goal.check_only = true;
  EXPECT_NEAR(planned(cell.submit(goal)), 2.2, 1e-3);
  CheckSequenceGoal sequence;
  sequence.steps = {turnTo(90), turnTo(0)};
  EXPECT_NEAR(planned(cell.submit(sequence)), 4.4, 1e-3);
}

TEST_F(SpeedOverrides, countForEachMoveOfACycle) {
  PickAndPlaceGoal goal;
  goal.steps.resize(2);
  goal.steps[0].move = turnTo(90);
  goal.steps[1].move = turnTo(0);
  for (PickAndPlaceStep& step : goal.steps) step.move.buffer_mode = 0;
  goal.cycles = 2;
  cell.setSpeedOverride(50);
  const GoalId cycle = cell.submit(goal);
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 80; }));
  cell.setSpeedOverride(100);
  expectDone(cycle);
  // Two steps at half the speed, or one, and the others at the full one.
  EXPECT_NEAR(toSeconds(*cell.endOf(cycle).actual), 2.2 + 3 * 1.2, 0.2);
}

TEST_F(SpeedOverrides, countForLinesInMillimetresASecond) {
  MoveRelativeGoal line;
  line.movement_command = static_cast<int>(Movement::Line);
  line.data_format = static_cast<int>(RelativeFormat::Cap);
  line.target = {0, 0, -100, 0, 0, 0};
  line.speed = 101;
  line.accel_time = 200;
  cell.setSpeedOverride(50);
  expectDone(cell.submit(line));
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",50,200,0,")) << "rounded down";
}

TEST_F(SpeedOverrides, neverSlowBelowOnePercent) {
  cell.setSpeedOverride(1);
  const GoalId move = cell.submit(turnTo(1, 20));
  expectDone(move);
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",1,200,0,"));
}

TEST_F(SpeedOverrides, leaveScriptsAsTheyAre) {
  cell.setSpeedOverride(50);
  RunScriptGoal script;
  script.script = "PTP(\"JPP\",90,0,90,0,90,0,50,200,0,false)";
  script.await_motion = true;
  const GoalId id = cell.submit(script);
  cell.pass(300ms);
  EXPECT_EQ(cell.group().effective_speed, 100);
  expectDone(id);
  EXPECT_NEAR(planned(id), 1.2, 1e-3);
}

TEST_F(SpeedOverrides, multiplyTheProjectSpeed) {
  cell.operate(simulator::SetProjectSpeed{50});
  cell.pass(100ms);
  const auto answer = cell.setSpeedOverride(50);
  EXPECT_EQ(answer->effective, 25);
  EXPECT_NEAR(planned(cell.submit(turnTo(90))), 90 / 22.5 + 0.2, 1e-3);
}

// --- 0 holds.

TEST_F(SpeedOverrides, ofNoughtHoldTheRobotOnItsWay) {
  const GoalId move = cell.submit(turnTo(90));
  cell.pass(500ms);
  cell.setSpeedOverride(0);
  cell.pass(500ms);
  ASSERT_TRUE(cell.overrideAnswer());
  EXPECT_TRUE(cell.overrideAnswer()->success);
  EXPECT_EQ(cell.overrideAnswer()->effective, 0);
  const double stands = joint1();
  cell.pass(10min);
  EXPECT_EQ(joint1(), stands);
  EXPECT_EQ(cell.outcome(move), nullptr);
  EXPECT_EQ(last(move).phase, Phase::Held);
  EXPECT_EQ(cell.group().sequence, command::GroupState::Sequence::Interrupted);
  EXPECT_EQ(cell.group().effective_speed, 0);
  cell.setSpeedOverride(100);
  cell.pass(100ms);
  ASSERT_TRUE(cell.overrideAnswer());
  EXPECT_EQ(cell.overrideAnswer()->effective, 100) << "it goes on, though the stream has shown a pause last";
  expectDone(move);
  EXPECT_NEAR(joint1(), 90, 1e-3);
}

TEST_F(SpeedOverrides, ofNoughtLetGoalsWaitInTheLayer) {
  cell.setSpeedOverride(0);
  const auto scripts = cell.scripts().size();
  const GoalId move = cell.submit(turnTo(90));
  cell.pass(10s);
  EXPECT_EQ(cell.scripts().size(), scripts) << "nothing is sent, not even a pause: the robot stands";
  EXPECT_FALSE(cell.accepted(move));
  EXPECT_THAT(last(move).text, HasSubstr("speed override"));
  cell.setSpeedOverride(50);
  expectDone(move);
  EXPECT_NEAR(planned(move), 2.2, 1e-3);
}

TEST_F(SpeedOverrides, ofNoughtLetAStopThrough) {
  const GoalId move = cell.submit(turnTo(90));
  cell.pass(500ms);
  cell.setSpeedOverride(0);
  cell.pass(500ms);
  const GoalId next = cell.submit(turnTo(0));
  expectDone(cell.submit(StopGoal{}));
  EXPECT_EQ(cell.endOf(move).ending, Ending::CommandAborted);
  EXPECT_EQ(cell.endOf(next).ending, Ending::CommandAborted);
  cell.setSpeedOverride(100);
  cell.pass(500ms);
  expectDone(cell.submit(turnTo(0)));
}

TEST_F(SpeedOverrides, doNotEndThePauseOfAnOperator) {
  const GoalId move = cell.submit(turnTo(90));
  cell.pass(500ms);
  cell.operate(simulator::PauseProject{});
  cell.pass(500ms);
  const auto zero = cell.setSpeedOverride(0);
  ASSERT_TRUE(zero);
  EXPECT_THAT(zero->message, HasSubstr("project is paused"));
  const auto answer = cell.setSpeedOverride(100);
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->message, HasSubstr("project is paused"));
  cell.pass(10s);
  EXPECT_EQ(cell.outcome(move), nullptr);
  cell.operate(simulator::ResumeProject{});
  expectDone(move);
}

TEST_F(SpeedOverrides, doNotEndAPauseThatCameBehindTheirs) {
  const GoalId move = cell.submit(turnTo(90));
  cell.pass(500ms);
  cell.setSpeedOverride(0);
  cell.pass(200ms);
  ProgramControlGoal pause;
  pause.command = static_cast<int>(ProgramCommand::Pause);
  cell.submit(pause);
  cell.pass(200ms);
  const auto answer = cell.setSpeedOverride(100);
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->message, HasSubstr("RESUME"));
  cell.pass(10s);
  EXPECT_EQ(cell.outcome(move), nullptr);
}

TEST_F(SpeedOverrides, tellWhenSomebodyLetsTheRobotGoAndSendNothingMore) {
  const GoalId move = cell.submit(turnTo(90));
  cell.pass(500ms);
  cell.setSpeedOverride(0);
  cell.pass(200ms);
  cell.operate(simulator::ResumeProject{});
  expectDone(move);
  EXPECT_THAT(cell.warnings(), ::testing::Contains(HasSubstr("speed override is 0 %")));
  EXPECT_EQ(cell.group().speed_override, 0);
  const GoalId next = cell.submit(turnTo(0));
  cell.pass(5s);
  EXPECT_FALSE(cell.accepted(next));
}

TEST_F(SpeedOverrides, holdOverALostLink) {
  cell.setSpeedOverride(30);
  cell.dropConnections();
  cell.pass(100ms);
  cell.connect();
  EXPECT_EQ(cell.group().speed_override, 30);
  EXPECT_NEAR(planned(cell.submit(turnTo(27))), 27 / 27.0 + 0.2, 1e-3);
}

TEST_F(SpeedOverrides, areSetWithoutALink) {
  CoreAndRobot alone;
  EXPECT_TRUE(alone.setSpeedOverride(0)->success);
  EXPECT_TRUE(alone.setSpeedOverride(70)->success);
  EXPECT_EQ(alone.group().speed_override, 70);
}

}  // namespace
}  // namespace cobot_command::testing
