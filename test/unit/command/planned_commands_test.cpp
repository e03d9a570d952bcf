// Commands that are planned beside the core before they are sent: what happens meanwhile.

#include "planned_commands.h"

#include "block_goals.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

TEST_F(CommandPlannedBeside, isSentWithItsPlan) {
  const GoalId id = rig.submit(toJoints(40));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_FALSE(rig.accepted(id));
  EXPECT_TRUE(rig.progress(id).empty()) << "it does not wait for anything that a caller knows of";
  EXPECT_EQ(rig.latest().commands_under_way, 1);
  EXPECT_EQ(rig.latest().commands_waiting, 0);
  rig.finishPlan();
  EXPECT_TRUE(rig.accepted(id));
  EXPECT_TRUE(isSent("PTP"));
  EXPECT_TRUE(rig.progress(id).back().planned);
}

TEST_F(CommandPlannedBeside, isRefusedByName) {
  const GoalId id = rig.submit(tooFar());
  rig.finishPlan();
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kJointLimit);
  EXPECT_EQ(endingOf(id), Ending::Rejected);
  EXPECT_FALSE(rig.accepted(id));
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CommandPlannedBeside, leavesTheRobotBusyForOthers) {
  rig.submit(toJoints(40));
  EXPECT_EQ(rig.outcome(rig.submit(toJoints(50)))->error_id, motion_error::kOtherBlockBusy);
}

TEST_F(CommandPlannedBeside, isNotWhatMovesNothing) {
  rig.submit(good<ChangeBaseGoal>());
  EXPECT_FALSE(rig.isPlanning());
  EXPECT_TRUE(isSent("ChangeBase"));
}

TEST_F(CommandPlannedBeside, isRefusedWhenItsLinkIsLost) {
  const GoalId id = rig.submit(toJoints(40));
  PlanAnswer late = rig.makePlan();
  rig.close("gone");
  EXPECT_EQ(endingOf(id), Ending::Rejected);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("gone"));
  rig.discardSent();
  rig.answerPlan(std::move(late));
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CommandPlannedBeside, endsUnsentWhenItIsCancelledOrStopped) {
  const std::function<void(CoreRig&, GoalId)> ends[] = {
      [](CoreRig& one, GoalId id) { one.cancel(id); },
      [](CoreRig& one, GoalId) { one.submit(StopGoal{}); },
      [](CoreRig& one, GoalId) { one.shutDown(); },
  };
  for (const auto& end : ends) {
    CoreRig beside{*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, Planning::Beside};
    beside.connect();
    beside.status(StatusFrames());
    const GoalId id = beside.submit(toJoints(40));
    PlanAnswer late = beside.makePlan();
    end(beside, id);
    ASSERT_NE(beside.outcome(id), nullptr);
    EXPECT_EQ(beside.outcome(id)->ending, Ending::CommandAborted);
    beside.discardSent();
    beside.answerPlan(std::move(late));  // the rig fails when a goal ends twice
    EXPECT_TRUE(beside.nothingSent());
  }
}

TEST_F(CommandPlannedBeside, doesNotHoldAStopBack) {
  rig.submit(toJoints(40));
  const GoalId stop = rig.submit(StopGoal{});
  EXPECT_TRUE(isSent("StopAndClearBuffer"));
  rig.reply(script.id);
  rig.stream(StatusFrames());
  EXPECT_EQ(endingOf(stop), Ending::Done);
}

TEST_F(CommandPlannedBeside, isRefusedWhenTheRobotIsInErrorBeforeItsPlanIsMade) {
  const GoalId id = rig.submit(toJoints(40));
  rig.status(StatusFrames().error(1, "IK"));
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kRobotError);
  rig.finishPlan();
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CommandPlannedBeside, isRefusedWhenThatTakesTooLong) {
  const GoalId id = rig.submit(toJoints(40));
  PlanAnswer late = rig.makePlan();
  rig.pass(10s);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kPlanningBudget);
  EXPECT_EQ(endingOf(id), Ending::Rejected);
  rig.answerPlan(std::move(late));
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CommandPlannedBeside, isPlannedAnewWhenTheRobotWasMovedMeanwhile) {
  const GoalId id = rig.submit(toJoints(40));
  rig.stream(StatusFrames().at({20, 0, 90, 0, 90, 0}), 3);
  rig.finishPlan();
  EXPECT_TRUE(rig.nothingSent()) << "that plan began where the robot is not any more";
  ASSERT_TRUE(rig.isPlanning());
  rig.finishPlan();
  EXPECT_TRUE(isSent("PTP"));

  CoreRig direct(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  direct.connect();
  direct.stream(StatusFrames().at({20, 0, 90, 0, 90, 0}), 3);
  const GoalId same = direct.submit(toJoints(40));
  direct.discardSent();
  EXPECT_EQ(rig.progress(id).back().planned, direct.progress(same).back().planned);
}

TEST_F(CommandPlannedBeside, isNotPlannedAnewForWhatTheStreamRounds) {
  rig.submit(toJoints(40));
  rig.stream(StatusFrames().at({0.01F, 0, 90, 0, 90, 0}));
  rig.finishPlan();
  EXPECT_TRUE(isSent("PTP"));
}

TEST_F(CommandPlannedBeside, comesBeforeWhatWaitsBehindItInTheOrderOfTheGoals) {
  const GoalId first = rig.submit(toJoints(40));
  const GoalId second = rig.submit(toJoints(60, BufferMode::Buffered));
  rig.finishPlanToSend();
  EXPECT_TRUE(rig.accepted(first));
  EXPECT_TRUE(isSent("PTP(\"JPP\",40"));
  rig.finishPlan();  // what is foreseen of the second
  EXPECT_TRUE(rig.nothingSent());
  arrive(40);
  EXPECT_EQ(endingOf(first), Ending::Done);
  rig.finishPlan();
  EXPECT_TRUE(rig.accepted(second));
  EXPECT_TRUE(isSent("PTP(\"JPP\",60"));
}

TEST_F(CommandPlannedBeside, isRefusedWhileItWaitsAndTakesNoneWithIt) {
  rig.submit(toJoints(40));
  rig.finishPlan();
  ASSERT_TRUE(isSent("PTP"));
  const GoalId wrong = rig.submit(tooFar(BufferMode::Buffered));
  const GoalId right = rig.submit(toJoints(60, BufferMode::Buffered));
  EXPECT_EQ(rig.outcome(wrong), nullptr);
  rig.finishPlan();
  EXPECT_EQ(endingOf(wrong), Ending::Rejected);
  EXPECT_EQ(rig.outcome(wrong)->error_id, own_error::kJointLimit);
  EXPECT_EQ(rig.outcome(right), nullptr);
  rig.finishPlan();
  arrive(40);
  rig.finishPlan();
  EXPECT_TRUE(isSent("PTP(\"JPP\",60"));
}

TEST_F(CommandPlannedBeside, isForeseenFromWhereTheOneInFrontOfItEnds) {
  rig.submit(toJoints(40));
  rig.finishPlan();
  ASSERT_TRUE(isSent("PTP"));
  rig.submit(toJoints(60, BufferMode::Buffered));
  MoveAbsoluteGoal back = toJoints(40);
  back.check_only = true;
  const GoalId check = rig.submit(back);
  rig.finishPlan();
  rig.finishPlan();
  ASSERT_EQ(endingOf(check), Ending::Done);
  const auto& path = rig.outcome(check)->detail.as<CheckedMotion>().joint_path;
  ASSERT_FALSE(path.empty());
  EXPECT_NEAR(path.front().joints[0], degToRad(60), 1e-6) << "asked for when that was not known yet";
}

TEST_F(CommandPlannedBeside, isWhateverComesNextInACycle) {
  PickAndPlaceGoal goal;
  goal.steps.push_back({toJoints(20), std::nullopt, std::nullopt, 0});
  goal.steps.push_back({toJoints(40), std::nullopt, std::nullopt, 0});
  const GoalId id = rig.submit(goal);
  rig.finishPlan();  // as a whole
  rig.finishPlan();
  ASSERT_TRUE(isSent("PTP(\"JPP\",20"));
  arrive(20);
  EXPECT_TRUE(rig.nothingSent());
  const GoalId stop = rig.submit(StopGoal{});
  EXPECT_EQ(endingOf(id), Ending::CommandAborted);
  EXPECT_TRUE(isSent("StopAndClearBuffer"));
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.finishPlan();
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CommandPlannedBeside, blendsFromWhereTheRobotWillBeWhenItIsSent) {
  const MoveAbsoluteGoal blended = blendedTo(40);
  rig.submit(blended);
  rig.finishPlan();
  ASSERT_TRUE(isSent("PTP"));
  rig.reply(script.id);
  const GoalId behind = rig.submit(toJoints(60));
  PlanAnswer answer = rig.makePlan();
  rig.pass(100ms);
  rig.answerPlan(std::move(answer));
  ASSERT_TRUE(isSent("PTP(\"JPP\",60"));
  rig.reply(script.id);

  CoreRig direct(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  direct.connect();
  direct.status(StatusFrames());
  direct.submit(blended);
  direct.reply(direct.takeScript().id);
  direct.pass(100ms);
  const GoalId same = direct.submit(toJoints(60));
  direct.reply(direct.takeScript().id);
  ASSERT_EQ(rig.progress(behind).back().phase, Phase::Queued);
  EXPECT_EQ(rig.progress(behind).back().planned, direct.progress(same).back().planned);
  rig.pass(2s);
  direct.pass(2s);
  EXPECT_EQ(rig.progress(behind).size(), direct.progress(same).size());
  EXPECT_EQ(rig.progress(behind).back().phase, direct.progress(same).back().phase);
}

/// A stream of an older controller: its TCP is computed from poses that tremble in their last bits.
StatusFrames trembling(int frame) {
  const auto j1 = static_cast<float>(0.002 * (frame % 3));
  StatusFrames frames;
  frames.at({j1, 0, 90, 0, 90, 0});
  frames.with(
      protocol::item::ofFloats("Coord_Robot_Flange", {517.5F + 0.01F * j1, -122.3F, 461.05F, 180, 0, 90}));
  frames.with(
      protocol::item::ofFloats("Coord_Robot_Tool", {517.5F, -122.3F + 0.01F * j1, 361.05F, 180, 0, 90}));
  return frames;
}

TEST_F(CommandPlannedBeside, isSentThoughTheStreamTrembles) {
  rig.stream(trembling(0));
  const GoalId id = rig.submit(toJoints(40));
  for (int frame = 1; frame < 20 && rig.isPlanning(); ++frame) {
    PlanAnswer answer = rig.makePlan();
    rig.stream(trembling(frame), 1);
    rig.answerPlan(std::move(answer));
  }
  EXPECT_TRUE(rig.accepted(id));
  EXPECT_TRUE(isSent("PTP"));
}

TEST_F(CommandPlannedBeside, isRefusedWhenWhatItStartsFromNeverStaysTheSame) {
  const GoalId id = rig.submit(toJoints(40));
  for (int i = 1; i < 2000 && rig.isPlanning(); ++i) {
    PlanAnswer answer = rig.makePlan();
    rig.stream(StatusFrames().with(protocol::item::ofInt("Project_Speed", 50 + i % 2)), 1);
    rig.pass(CoreRig::kStreamPeriod);
    rig.answerPlan(std::move(answer));
  }
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kPlanningBudget);
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CommandPlannedBeside, takesWithItWhatCameBehindItWhenItIsCancelled) {
  const GoalId first = rig.submit(toJoints(40));
  const GoalId second = rig.submit(toJoints(60, BufferMode::Buffered));
  rig.cancel(first);
  EXPECT_EQ(endingOf(first), Ending::CommandAborted);
  ASSERT_NE(rig.outcome(second), nullptr);
  EXPECT_EQ(endingOf(second), Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(second)->error_description, HasSubstr("was cancelled"));
}

TEST_F(CommandPlannedBeside, stopsTheBlendedMotionInFrontOfItWhenItIsCancelled) {
  rig.submit(blendedTo(40));
  rig.finishPlan();
  ASSERT_TRUE(isSent("PTP"));
  rig.reply(script.id);
  const GoalId second = rig.submit(toJoints(60));
  rig.cancel(second);
  EXPECT_EQ(endingOf(second), Ending::CommandAborted);
  EXPECT_TRUE(isSent("StopAndClearBuffer"));
}

TEST_F(CommandPlannedBeside, isCarriedOutByAFinishThatDropsWhatIsBehindIt) {
  const GoalId first = rig.submit(toJoints(40));
  const GoalId second = rig.submit(toJoints(60, BufferMode::Buffered));
  const FinishReport report = rig.core.finish(FinishAfter::Move, rig.now);
  rig.pump();
  EXPECT_EQ(report.under_way, kBlock<MoveAbsoluteGoal>);
  EXPECT_EQ(report.dropped, 1);
  EXPECT_EQ(endingOf(second), Ending::CommandAborted);
  rig.finishPlanToSend();
  EXPECT_TRUE(rig.accepted(first));
  EXPECT_TRUE(isSent("PTP"));
}

}  // namespace
}  // namespace cobot_command::testing
