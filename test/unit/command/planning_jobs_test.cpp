// Planning beside the core: who waits for a plan, and what happens meanwhile.

#include "block_goals.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/list/goal.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

MoveAbsoluteGoal toJoints(double j1, bool check_only = false) {
  MoveAbsoluteGoal goal = moveJoints({j1, 0, 90, 0, 90, 0}, 10);
  goal.check_only = check_only;
  return goal;
}

CheckSequenceGoal sequence(std::size_t steps = 2) {
  CheckSequenceGoal goal;
  for (std::size_t i = 0; i < steps; ++i) goal.steps.emplace_back(toJoints(10.0 * static_cast<double>(i)));
  return goal;
}

PickAndPlaceGoal cycle(BufferMode mode = BufferMode::Refuse) {
  PickAndPlaceGoal goal;
  goal.buffer_mode = static_cast<int>(mode);
  goal.steps.push_back({toJoints(20), std::nullopt, std::nullopt, 0});
  return goal;
}

struct Planned : CoreRig {
  Planned() : CoreRig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}, Planning::Beside) {
    connect();
    status(StatusFrames());
  }
  Ending endingOf(GoalId id) {
    EXPECT_NE(outcome(id), nullptr);
    return outcome(id) == nullptr ? Ending::Rejected : outcome(id)->ending;
  }
};

TEST(PlanBesideTheCore, answersAWholeSequenceWhenItIsMade) {
  Planned rig;
  const GoalId id = rig.submit(sequence());
  EXPECT_TRUE(rig.isPlanning());
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(id), Ending::Done);
  EXPECT_EQ(rig.outcome(id)->detail.as<SequenceReport>().steps.size(), 2U);
}

TEST(PlanBesideTheCore, answersACheckOfOneMoveWithItsPath) {
  Planned rig;
  const GoalId id = rig.submit(toJoints(30, true));
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(id), Ending::Done);
  EXPECT_FALSE(rig.outcome(id)->detail.as<CheckedMotion>().joint_path.empty());
}

TEST(PlanBesideTheCore, isTheSameAsOneThatIsMadeAtOnce) {
  Planned rig;
  const GoalId beside = rig.submit(sequence(4));
  rig.finishPlan();
  CoreRig direct(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  direct.connect();
  direct.status(StatusFrames());
  const GoalId at_once = direct.submit(sequence(4));
  EXPECT_EQ(rig.outcome(beside)->planned, direct.outcome(at_once)->planned);
}

TEST(PlanBesideTheCore, isMadeOneAtATimeInTheOrderOfTheGoals) {
  Planned rig;
  const GoalId first = rig.submit(sequence());
  const GoalId second = rig.submit(toJoints(30, true));
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(first), Ending::Done);
  EXPECT_EQ(rig.outcome(second), nullptr);
  ASSERT_TRUE(rig.isPlanning());
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(second), Ending::Done);
}

TEST(PlanBesideTheCore, isForNobodyWhenItsGoalWasCancelledMeanwhile) {
  Planned rig;
  const GoalId id = rig.submit(sequence());
  const PlanAnswer late = rig.makePlan();
  rig.cancel(id);
  EXPECT_EQ(rig.endingOf(id), Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("while it was planned"));
  rig.answerPlan(late);  // the rig fails when a goal ends twice
}

TEST(PlanBesideTheCore, endsEarlyWhenNobodyWaitsForItAnyMore) {
  Planned rig;
  const GoalId id = rig.submit(sequence(5));
  rig.cancel(id);
  EXPECT_TRUE(rig.makePlan().outcome.detail.as<SequenceReport>().steps.empty());
}

TEST(PlanBesideTheCore, hasABudgetThatBeginsWithItsWork) {
  Planned rig;
  const GoalId first = rig.submit(sequence());
  const GoalId second = rig.submit(sequence());
  rig.pass(9999ms);
  EXPECT_EQ(rig.outcome(first), nullptr);
  rig.pass(1ms);
  EXPECT_EQ(rig.outcome(first)->error_id, own_error::kPlanningBudget);
  EXPECT_EQ(rig.outcome(second), nullptr);
  rig.pass(9999ms);
  EXPECT_EQ(rig.outcome(second), nullptr);
  rig.pass(1ms);
  EXPECT_EQ(rig.outcome(second)->error_id, own_error::kPlanningBudget);
}

TEST(PlanBesideTheCore, delaysNeitherCommandsNorStops) {
  Planned rig;
  const GoalId check = rig.submit(sequence());
  const GoalId move = rig.submit(toJoints(40));
  rig.finishPlanToSend();
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(move), nullptr);
  const GoalId stop = rig.submit(StopGoal{});
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
  rig.discardSent();
  EXPECT_EQ(rig.outcome(check), nullptr);
  EXPECT_EQ(rig.outcome(stop), nullptr);
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(check), Ending::Done);
}

TEST(PlanBesideTheCore, isDroppedWhenTheLayerShutsDown) {
  Planned rig;
  const GoalId check = rig.submit(sequence());
  const GoalId waiting = rig.submit(cycle());
  rig.shutDown();
  EXPECT_EQ(rig.endingOf(check), Ending::CommandAborted);
  EXPECT_EQ(rig.endingOf(waiting), Ending::CommandAborted);
  rig.finishPlan();
}

TEST(CycleThatIsPlanned, beginsWithItsPlan) {
  Planned rig;
  const GoalId id = rig.submit(cycle());
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_FALSE(rig.accepted(id));
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr("planned as a whole"));
  EXPECT_EQ(rig.outcome(rig.submit(toJoints(40)))->error_id, motion_error::kOtherBlockBusy);
  rig.finishPlan();
  EXPECT_TRUE(rig.accepted(id));
  EXPECT_TRUE(rig.nothingSent()) << "each move is planned once more, from where the robot is";
  rig.finishPlan();
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(CycleThatIsPlanned, doesNotWaitForChecksNorTheyForIt) {
  Planned rig;
  const GoalId check = rig.submit(sequence());
  const GoalId other = rig.submit(sequence());
  const GoalId id = rig.submit(cycle());
  rig.finishPlanToSend();
  EXPECT_TRUE(rig.accepted(id));
  rig.finishPlanToSend();
  rig.takeScript();
  EXPECT_EQ(rig.outcome(check), nullptr);
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(check), Ending::Done);
  rig.finishPlan();
  EXPECT_EQ(rig.endingOf(other), Ending::Done);
}

TEST(PlanBesideTheCore, endsInItsBudgetHoweverManyMovesAreSentMeanwhile) {
  Planned rig;
  const GoalId check = rig.submit(sequence());
  double j1 = 0;
  for (int i = 0; i < 9; ++i) {
    j1 = j1 == 0 ? 40 : 0;
    const GoalId move = rig.submit(toJoints(j1));
    rig.finishPlanToSend();
    rig.reply(rig.takeScript().id);
    rig.tag(rig.latest().open_tags.at(0));
    rig.stream(StatusFrames().at({static_cast<float>(j1), 0, 90, 0, 90, 0}));
    EXPECT_EQ(rig.endingOf(move), Ending::Done);
    rig.pass(900ms);
  }
  EXPECT_EQ(rig.outcome(check), nullptr);
  rig.pass(2s);
  EXPECT_EQ(rig.outcome(check)->error_id, own_error::kPlanningBudget);
}

TEST(CycleThatIsPlanned, countsAsUnderWay) {
  Planned rig;
  const GoalId move = rig.submit(toJoints(40));
  rig.finishPlan();
  const auto script = rig.takeScript();
  const GoalId id = rig.submit(cycle(BufferMode::Buffered));
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr("after one other"));
  rig.reply(script.id);
  rig.tag(rig.latest().open_tags.at(0));
  rig.status(StatusFrames().at({40, 0, 90, 0, 90, 0}));
  EXPECT_EQ(rig.endingOf(move), Ending::Done);
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr("planned as a whole"));
  EXPECT_EQ(rig.latest().commands_under_way, 1);
  EXPECT_EQ(rig.latest().commands_waiting, 0);
}

TEST(CycleThatIsPlanned, isRefusedWithTheStepThatCannotBeMade) {
  Planned rig;
  PickAndPlaceGoal goal = cycle();
  goal.steps[0].move.target[2] = 170;
  const GoalId id = rig.submit(goal);
  rig.finishPlan();
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStepRefused);
  EXPECT_FALSE(rig.accepted(id));
}

TEST(CycleThatIsPlanned, endsWithoutAMoveWhenItIsCancelledStoppedOrLosesItsLink) {
  const auto ends = [](const std::function<void(Planned&, GoalId)>& what) {
    Planned rig;
    const GoalId id = rig.submit(cycle());
    const PlanAnswer late = rig.makePlan();
    what(rig, id);
    EXPECT_EQ(rig.endingOf(id), Ending::CommandAborted);
    rig.discardSent();
    rig.answerPlan(late);
    EXPECT_TRUE(rig.nothingSent());
  };
  ends([](Planned& rig, GoalId id) { rig.cancel(id); });
  ends([](Planned& rig, GoalId) { rig.submit(StopGoal{}); });
  ends([](Planned& rig, GoalId) { rig.close("gone"); });
}

TEST(CycleThatIsPlanned, isRefusedWhenTheRobotIsInErrorBeforeItsPlanIsMade) {
  Planned rig;
  const GoalId id = rig.submit(cycle());
  rig.status(StatusFrames().error(1, "IK"));
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kRobotError);
  rig.finishPlan();
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PlanningBeside, takesNoMoreChecksThanMayWait) {
  Planned rig;
  for (std::size_t i = 0; i < kMostWaiting; ++i) {
    EXPECT_EQ(rig.outcome(rig.submit(toJoints(10, true))), nullptr) << i;
  }
  const GoalId one_more = rig.submit(sequence());
  ASSERT_NE(rig.outcome(one_more), nullptr);
  EXPECT_EQ(rig.outcome(one_more)->error_id, own_error::kQueueFull);
  EXPECT_THAT(rig.outcome(one_more)->error_description, HasSubstr("64"));

  rig.finishPlan();
  EXPECT_EQ(rig.outcome(rig.submit(sequence())), nullptr) << "there is room again";
}

}  // namespace
}  // namespace cobot_command::testing
