// The master clock of paths: as fast as the feedrate says, and stopped on their way.
#include "path_goals.h"
#include <gmock/gmock.h>

#include "cobot_command/common/units.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

class LoadPathFeedrate : public LoadPathCell {
 protected:
  /// Oracle 1: joint 1 from 0 to 90 degrees in 1.5 s.
  [[nodiscard]] static LoadPathGoal quarterTurn(double to = 90) {
    LoadPathGoal goal;
    path::PathPoint point = pathPoint({to, 0, 90, 0, 90, 0});
    point.speed = 90;
    point.acceleration = 180;
    point.deceleration = 180;
    goal.path = {point};
    goal.number_of_moves = 1;
    return goal;
  }
  /// By a script, exactly; at half the feedrate, too.
  [[nodiscard]] static LoadPathGoal sayable() {
    LoadPathGoal goal = turns(20, false);
    goal.execution = static_cast<int>(Execution::Script);
    for (path::PathPoint& point : goal.path) {
      point.speed = 36;  // 20 % of the rated speed
      point.acceleration = 180;
      point.deceleration = 180;
    }
    return goal;
  }
  [[nodiscard]] double duration(GoalId id) { return toSeconds(*cell.endOf(id).planned); }
  [[nodiscard]] double joint1() { return radToDeg(cell.robot().joints[0]); }
  [[nodiscard]] Phase phaseOf(GoalId id) { return cell.progress(id).back().phase; }
};

/// Oracle 20.
TEST_F(LoadPathFeedrate, isTheTimeOfAllThatIsPlanned) {
  EXPECT_TRUE(cell.setFeedrate(50)->success);
  const GoalId half = cell.submit(quarterTurn());
  double fastest = 0;
  double before = joint1();
  while (cell.outcome(half) == nullptr) {
    cell.pass(20ms);
    fastest = std::max(fastest, (joint1() - before) / 0.02);
    before = joint1();
  }
  expectDone(half);
  EXPECT_NEAR(duration(half), 3.0, 1e-3);
  EXPECT_NEAR(toSeconds(*cell.endOf(half).actual), 3.0, 0.05);
  EXPECT_NEAR(fastest, 45, 0.1);
  EXPECT_TRUE(cell.setFeedrate(125)->success);
  const GoalId fast = cell.submit(quarterTurn(0));
  expectDone(fast);
  EXPECT_NEAR(duration(fast), 1.2, 1e-3);
}

/// Oracle 20.
TEST_F(LoadPathFeedrate, isRefusedOutsideItsRangeAndStaysAsItWas) {
  for (const double percent : {125.1, -1.0, std::numeric_limits<double>::quiet_NaN(), 5e-324, 9e-5}) {
    const auto answer = cell.setFeedrate(percent);
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->error_id, own_error::kFeedrateRange);
    EXPECT_THAT(answer->message, HasSubstr("allowed: 0 to 125, and at least 0.0001"));
  }
  EXPECT_EQ(cell.controls(), path::PathControls());
}

TEST_F(LoadPathFeedrate, isNamedWhereAPathTakesTooLongWithIt) {
  EXPECT_TRUE(cell.setFeedrate(0.0001)->success);
  const Outcome& outcome = cell.endOf(cell.submit(quarterTurn()));
  EXPECT_EQ(outcome.error_id, own_error::kNotPlannable);
  EXPECT_THAT(outcome.error_description, HasSubstr("applies to the feedrate of 0.0001 %"));
}

/// Oracle 20.
TEST_F(LoadPathFeedrate, ofNoughtStopsTheRobotOnItsWay) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setFeedrate(0);
  cell.pass(300ms);
  ASSERT_TRUE(cell.feedrateAnswer() && cell.feedrateAnswer()->success);
  const double stands = joint1();
  EXPECT_EQ(phaseOf(id), Phase::Held);
  EXPECT_THAT(cell.progress(id).back().text, HasSubstr("resume_path"));
  cell.pass(10min);
  EXPECT_EQ(joint1(), stands);
  EXPECT_EQ(cell.outcome(id), nullptr) << "deadlines stand still";
  cell.setFeedrate(100);
  expectDone(id);
  EXPECT_NEAR(joint1(), 90, 1e-3);
  EXPECT_LT(reportOf(id).max_joint_deviation, 0.5) << "along the same path";
  EXPECT_EQ(cell.scripts().back(), "Resume()");
}

TEST_F(LoadPathFeedrate, goesOnAsItWasBeforeTheStop) {
  cell.setFeedrate(50);
  cell.setFeedrate(0);
  const GoalId id = cell.submit(quarterTurn());
  cell.pass(1min);
  EXPECT_TRUE(cell.scripts().empty()) << "nothing is sent, nor paused";
  EXPECT_EQ(phaseOf(id), Phase::Held);
  EXPECT_TRUE(cell.setFeedrate(std::nullopt)->success);
  expectDone(id);
  EXPECT_NEAR(duration(id), 3.0, 1e-3);
}

TEST_F(LoadPathFeedrate, countsForWhatIsNotSentAtOnce) {
  const GoalId id = cell.submit(turns(20, false));
  const GoalId behind = cell.submit(turns(3, true, 20));
  passUntilActive(id, 3);
  const double planned = toSeconds(*cell.progress(behind).back().planned);
  const auto answer = cell.setFeedrate(50);
  EXPECT_TRUE(answer->success);
  EXPECT_EQ(answer->effective, 100);
  EXPECT_EQ(answer->from_point, 5) << "two pieces are at the controller";
  expectDone(id);
  expectDone(behind);
  const auto& points = reportOf(id).points;
  EXPECT_NEAR(toSeconds(points[5].duration), 2 * toSeconds(points[4].duration), 0.01);
  EXPECT_NEAR(toSeconds(points[19].done), toSeconds(points[19].start + points[19].duration), 0.1);
  EXPECT_NEAR(duration(behind), 2 * planned, 0.02);
  EXPECT_TRUE(reportOf(behind).blends_lost == std::vector<int>{2}) << "but for the open end none is lost";
  EXPECT_NEAR(joint1(), 69, 0.01);
}

TEST_F(LoadPathFeedrate, countsForAnOpenEnd) {
  const GoalId id = cell.submit(turns(3, true));
  EXPECT_TRUE(cell.setFeedrate(50)->success);
  const GoalId behind = cell.submit(turns(3, true, 3));
  expectDone(id);
  expectDone(behind);
  EXPECT_TRUE(reportOf(id).blends_lost.empty()) << "one PVT of both, at the new one";
  EXPECT_EQ(cell.scripts().size(), 1U);
}

TEST_F(LoadPathFeedrate, isRefusedWhereAJointWouldBeTooFast) {
  LoadPathGoal goal;
  for (const double to : {60, 0, 60, 0, 60, 0}) {
    goal.path.push_back(pathPoint({to, 0, 90, 0, 90, 0}));
    goal.path.back().speed = 170;
    goal.path.back().acceleration = goal.path.back().deceleration = 1000;
  }
  goal.number_of_moves = 6;
  const GoalId id = cell.submit(goal);
  passUntilActive(id, 1);
  const auto answer = cell.setFeedrate(125);
  EXPECT_EQ(answer->error_id, own_error::kJointSpeed);
  EXPECT_THAT(answer->message, HasSubstr("highest possible feedrate: 105.9 %"));
  EXPECT_EQ(cell.controls().feedrate, 1.0);
  expectDone(id);
}

TEST_F(LoadPathFeedrate, isSaidByAScriptAsFarAsThatCan) {
  const GoalId id = cell.submit(sayable());
  passUntilActive(id, 2);
  EXPECT_TRUE(cell.setFeedrate(50)->success);
  expectDone(id);
  EXPECT_THAT(cell.scripts()[7], HasSubstr(",20,200,"));
  EXPECT_THAT(cell.scripts()[8], HasSubstr(",10,400,"));
  EXPECT_EQ(cell.scripts().size(), 20U);
}

TEST_F(LoadPathFeedrate, thatCannotBeIsNeverExceeded) {
  const GoalId id = cell.submit(sayable());
  passUntilActive(id, 2);
  EXPECT_TRUE(cell.setFeedrate(101)->success);
  cell.pass(1s);
  EXPECT_THAT(cell.warnings(), ::testing::Contains(HasSubstr("the path keeps its feedrate")));
  EXPECT_TRUE(cell.setFeedrate(51)->success);
  cell.pass(1min);
  EXPECT_EQ(cell.outcome(id), nullptr) << "nothing is sent that would be faster";
  EXPECT_EQ(phaseOf(id), Phase::Held);
  EXPECT_THAT(cell.progress(id).back().text, HasSubstr("at a feedrate of 51 %"));
  EXPECT_TRUE(cell.setFeedrate(50)->success);
  expectDone(id);
  EXPECT_THAT(cell.scripts().back(), HasSubstr(",10,400,"));
}

TEST_F(LoadPathFeedrate, ofAScriptLeavesBaseAndTcpAsTheyWere) {
  arm::Pose tool = arm::Pose::Identity();
  tool.translation().z() = 0.1;
  ASSERT_TRUE(cell.write({3, std::optional(tables::Tool{"", tool, 0})}));
  LoadPathGoal goal = sayable();
  path::PathPoint first = pathLine({417.5, -122.3, 381.05, 180, 0, 90});
  first.pose_type = static_cast<int>(path::MovedFrame::Tool);
  first.pose_id = 3;
  goal.path.insert(goal.path.begin(), first);
  goal.number_of_moves = 21;
  goal.allow_approximation = true;
  const GoalId id = cell.submit(goal);
  passUntilActive(id, 3);
  EXPECT_TRUE(cell.setFeedrate(50)->success);
  expectDone(id);
  ASSERT_THAT(cell.scripts().front(), HasSubstr("ChangeTCP"));
  EXPECT_THAT(cell.scripts().back(), HasSubstr("ChangeTCP")) << "though what was planned again sets none";
}

TEST_F(LoadPathFeedrate, ofNoughtIsToldAsHeldOnlyWhenTheControllerHasTakenIt) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.operate(simulator::SetFault{"refuse_script", true, 1, 0, "1"});
  cell.setFeedrate(0);
  cell.pass(200ms);
  ASSERT_TRUE(cell.feedrateAnswer());
  EXPECT_FALSE(cell.feedrateAnswer()->success);
  for (const Progress& progress : cell.progress(id)) EXPECT_NE(progress.phase, Phase::Held);
  EXPECT_TRUE(cell.controls().stopped && !cell.controls().held);
  expectDone(id);
}

TEST_F(LoadPathFeedrate, leavesAPauseThatCameBehindItsOwnToWhomeverPaused) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setFeedrate(0);
  cell.pass(1s);
  cell.submit(ProgramControlGoal{0, 0});
  cell.pass(1s);
  const auto answer = cell.setFeedrate(std::nullopt);
  ASSERT_TRUE(answer);
  EXPECT_THAT(answer->message, HasSubstr("program_control with RESUME"));
  cell.pass(1min);
  EXPECT_EQ(cell.outcome(id), nullptr);
  cell.submit(ProgramControlGoal{0, 1});
  expectDone(id);
}

TEST_F(LoadPathFeedrate, leavesAPauseOfSomebodyElseToHim) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.operate(simulator::PauseProject{});
  cell.pass(1s);
  cell.setFeedrate(0);
  cell.setFeedrate(100);
  cell.pass(1min);
  EXPECT_EQ(cell.outcome(id), nullptr);
  EXPECT_EQ(cell.scripts().size(), 1U) << "neither Pause() nor Resume()";
  cell.operate(simulator::ResumeProject{});
  expectDone(id);
}

TEST_F(LoadPathFeedrate, ofNoughtOutlastsAnEmergencyStop) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setFeedrate(0);
  cell.pass(1s);
  cell.operate(simulator::SetEmergencyStop{true});
  cell.endOf(id);
  EXPECT_TRUE(cell.controls().stopped);
}

TEST_F(LoadPathFeedrate, ofNoughtWithoutALinkIsKept) {
  cell.dropConnections();
  const auto answer = cell.setFeedrate(0);
  ASSERT_TRUE(answer);
  EXPECT_TRUE(cell.controls().stopped);
  EXPECT_TRUE(cell.setFeedrate(std::nullopt));
  EXPECT_FALSE(cell.controls().stopped);
}

TEST_F(LoadPathFeedrate, ofNoughtLetsAFinishDropWhatWaits) {
  cell.setFeedrate(0);
  const GoalId id = cell.submit(quarterTurn());
  cell.pass(1s);
  cell.finish();
  ASSERT_NE(cell.outcome(id), nullptr);
  EXPECT_EQ(cell.outcome(id)->ending, Ending::CommandAborted);
}

TEST_F(LoadPathFeedrate, ofNoughtIsOverWhenSomebodyLetsTheProjectGo) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setFeedrate(0);
  cell.pass(1s);
  cell.operate(simulator::ResumeProject{});
  expectDone(id);
  EXPECT_FALSE(cell.controls().stopped);
  EXPECT_THAT(cell.warnings(),
              ::testing::Contains(HasSubstr("another client or the pendant has resumed it")));
}

TEST_F(LoadPathFeedrate, ofNoughtLetsTheGoalBeCancelled) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.setFeedrate(0);
  cell.pass(1s);
  cell.cancel(id);
  EXPECT_EQ(cell.endOf(id).ending, Ending::CommandAborted);
  const GoalId next = cell.submit(quarterTurn(0));
  cell.pass(1min);
  EXPECT_EQ(cell.outcome(next), nullptr) << "it waits";
  cell.setFeedrate(100);
  expectDone(next);
}

TEST_F(LoadPathFeedrate, isTakenAsTheLastOneSaysHoweverFastTheyCome) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  for (const double percent : {0.0, 100.0, 0.0, 80.0, 0.0}) cell.setFeedrate(percent);
  cell.pass(5s);
  EXPECT_EQ(cell.outcome(id), nullptr);
  EXPECT_TRUE(cell.controls().stopped);
  for (const double percent : {100.0, 0.0, 100.0}) cell.setFeedrate(percent);
  expectDone(id);
}

TEST_F(LoadPathFeedrate, isNotAnsweredAsDoneWhenTheLinkIsLost) {
  const GoalId id = cell.submit(quarterTurn());
  ASSERT_TRUE(cell.passUntil([&] { return joint1() > 20; }));
  cell.operate(simulator::SetFault{"silence", true, 0, 0, ""});
  cell.setFeedrate(0);
  EXPECT_FALSE(cell.feedrateAnswer());
  cell.endOf(id);
  ASSERT_TRUE(cell.feedrateAnswer());
  EXPECT_FALSE(cell.feedrateAnswer()->success);
}

}  // namespace
}  // namespace cobot_command::testing
