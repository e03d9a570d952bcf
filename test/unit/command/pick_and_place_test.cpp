// The pick-and-place cycle: six moves, two dwells, again and again, to be paused and stopped at any moment.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

PickAndPlaceGoal cycle(int cycles = 1) {
  PickAndPlaceGoal goal;
  goal.cycles = cycles;
  for (int i = 0; i < 6; ++i) {
    PickAndPlaceStep step;
    step.move = CoreRig::move();
    step.move.target[0] = 400 + i;
    goal.steps.push_back(step);
  }
  goal.steps[2].dwell = 2;
  goal.steps[5].dwell = 2;
  goal.steps[2].output = SetOutputGoal{0, "EndModule", 0, 1};
  return goal;
}

void move(CoreRig& rig, int x) {
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, HasSubstr("PTP(\"CPP\"," + std::to_string(x)));
  rig.reply(script.id);
  rig.tag(rig.latest().open_tags.at(0));
}

void setOutput(CoreRig& rig) {
  const auto script = rig.takeScript();
  EXPECT_EQ(script.script, "IO[\"EndModule\"].DO[0]=1");
  rig.reply(script.id);
}

void runCycle(CoreRig& rig) {
  for (const int x : {400, 401, 402}) move(rig, x);
  setOutput(rig);
  EXPECT_TRUE(rig.nothingSent()) << "it dwells";
  rig.pass(2s);
  for (const int x : {403, 404, 405}) move(rig, x);
  EXPECT_TRUE(rig.nothingSent()) << "it dwells";
  rig.pass(2s);
}

TEST(PickAndPlace, makesItsMovesInOrderWithTheDwellsAndIsDoneAfterTheLastOne) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  EXPECT_TRUE(rig.outputs(kBlock<PickAndPlaceGoal>).busy);
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  runCycle(rig);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 1);
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().failed_step, -1);
}

TEST(PickAndPlace, repeatsAsOftenAsItIsTold) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle(3));
  for (int i = 1; i <= 3; ++i) {
    EXPECT_EQ(rig.progress(goal).back().detail.as<CyclePlace>().cycle, i);
    EXPECT_EQ(rig.progress(goal).back().detail.as<CyclePlace>().step, 0);
    runCycle(rig);
  }
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 3);
}

TEST(PickAndPlace, runsUntilItIsCancelledWhenNoNumberIsGiven) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle(0));
  for (int i = 0; i < 10; ++i) runCycle(rig);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  const auto script = rig.takeScript();
  rig.reply(script.id);
  rig.cancel(goal);
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 10);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PickAndPlace, endsAtOnceWhenItIsCancelledInADwell) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  for (const int x : {400, 401, 402}) move(rig, x);
  setOutput(rig);
  EXPECT_EQ(rig.progress(goal).back().phase, Phase::Dwelling);
  rig.cancel(goal);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  rig.pass(10s);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PickAndPlace, holdsADwellAsLongAsTheRobotIsPaused) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  for (const int x : {400, 401, 402}) move(rig, x);
  setOutput(rig);
  rig.pass(500ms);
  rig.status(StatusFrames().paused());
  for (int i = 0; i < 100; ++i) {
    rig.pass(100ms);
    rig.status(StatusFrames().paused());
  }
  EXPECT_TRUE(rig.nothingSent());
  rig.status(StatusFrames());
  rig.pass(900ms);
  rig.status(StatusFrames());
  rig.pass(500ms);
  EXPECT_TRUE(rig.nothingSent());
  rig.status(StatusFrames());
  rig.pass(101ms);
  move(rig, 403);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.discardSent();
}

TEST(PickAndPlace, namesTheStepThatFailsAndWhy) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  move(rig, 400);
  rig.reply(rig.takeScript().id, false, {1});
  const Outcome* outcome = rig.outcome(goal);
  ASSERT_NE(outcome, nullptr);
  EXPECT_EQ(outcome->ending, Ending::Aborted);
  EXPECT_EQ(outcome->error_id, own_error::kStepFailed);
  EXPECT_EQ(outcome->detail.as<CycleReport>().failed_step, 1);
  EXPECT_THAT(outcome->error_description, HasSubstr("step 2 of 6"));
  ASSERT_EQ(outcome->detail.as<CycleReport>().steps.size(), 6u);
  EXPECT_EQ(outcome->detail.as<CycleReport>().steps[1].error_id, motion_error::kRejected);
  EXPECT_TRUE(rig.nothingSent());
}

/// The flow leaves the Listen node between two steps.
TEST(PickAndPlace, keepsNoTagOfAMoveThatIsRefusedBetweenTwoSteps) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  for (const int x : {400, 401, 402}) move(rig, x);
  setOutput(rig);
  rig.listening = false;
  rig.pass(2s);
  const Outcome* outcome = rig.outcome(goal);
  ASSERT_NE(outcome, nullptr);
  EXPECT_EQ(outcome->error_id, own_error::kStepRefused) << outcome->error_description;
  EXPECT_THAT(outcome->error_description, HasSubstr("16#220"));
  EXPECT_EQ(outcome->detail.as<CycleReport>().failed_step, 3);
  EXPECT_TRUE(rig.latest().open_tags.empty());
}

TEST(PickAndPlace, saysOfAnOutputThatCouldNotBeSentThatItIsNotSet) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  for (const int x : {400, 401}) move(rig, x);
  rig.reply(rig.takeScript().id);
  rig.listening = false;
  rig.pass(2s);  // the move that is under way goes on
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.tag(rig.latest().open_tags.at(0));
  const Outcome* outcome = rig.outcome(goal);
  ASSERT_NE(outcome, nullptr);
  EXPECT_EQ(outcome->ending, Ending::Aborted);
  EXPECT_EQ(outcome->error_id, own_error::kOutputFailed) << outcome->error_description;
  EXPECT_THAT(outcome->error_description,
              HasSubstr("Output not set: the output of step 3 of 6, cycle 1: 16#220"));
  EXPECT_THAT(outcome->error_description, ::testing::Not(HasSubstr("Step refused")));
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PickAndPlace, tellsOfACancelWhatBecameOfTheRobot) {
  CoreRig rig;
  rig.connect();
  const GoalId moving = rig.submit(cycle());
  rig.reply(rig.takeScript().id);
  rig.cancel(moving);
  rig.reply(rig.takeScript().id);
  EXPECT_THAT(rig.outcome(moving)->error_description,
              HasSubstr("cancelled; the controller accepted the stop, but no status stream shows"));

  const GoalId dwelling = rig.submit(cycle());
  for (const int x : {400, 401, 402}) move(rig, x);
  setOutput(rig);
  rig.cancel(dwelling);
  EXPECT_EQ(rig.outcome(dwelling)->error_description, "cancelled; no motion was running");
}

TEST(PickAndPlace, tellsAtTheEndOfTheLayerWhatBecameOfTheRobot) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId goal = rig.submit(cycle());
  rig.reply(rig.takeScript().id);
  rig.core.retire(rig.now);
  rig.pump();
  rig.reply(rig.takeScript().id);
  rig.stream(StatusFrames());
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_THAT(rig.outcome(goal)->error_description,
              ::testing::AllOf(HasSubstr("shutting down"), HasSubstr("the robot was stopped")));
}

TEST(PickAndPlace, endsWithTheLinkAlsoInADwell) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  for (const int x : {400, 401, 402}) move(rig, x);
  setOutput(rig);
  rig.close("cable pulled");
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, motion_error::kLinkDropped);
}

TEST(PickAndPlace, isStoppedByTheStopBlock) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle());
  rig.reply(rig.takeScript().id);
  rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("stop block"));
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PickAndPlace, refusesOtherCommandsAndKeepsBufferedOnes) {
  CoreRig rig;
  rig.connect();
  rig.submit(cycle());
  const GoalId refused = rig.submit(CoreRig::move());
  EXPECT_EQ(rig.outcome(refused)->error_id, motion_error::kOtherBlockBusy);
  MoveAbsoluteGoal behind = CoreRig::move(BufferMode::Buffered);
  behind.target[0] = 300;
  rig.submit(behind);
  runCycle(rig);
  move(rig, 300);
}

TEST(PickAndPlace, isCheckedAsAWholeBeforeTheFirstMove) {
  CoreRig rig(arm::ArmModel::named("tm5-900").value(), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  PickAndPlaceGoal goal = cycle();
  goal.steps[4].move.target = {3000, 0, 300, 180, 0, 90};
  const GoalId id = rig.submit(goal);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kStepRefused);
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().failed_step, 4);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PickAndPlace, checkOnlySendsNothingAndTellsTheTimes) {
  CoreRig rig(arm::ArmModel::named("tm5-900").value(), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  PickAndPlaceGoal goal = cycle();
  goal.check_only = true;
  const GoalId id = rig.submit(goal);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  ASSERT_EQ(rig.outcome(id)->detail.as<CycleReport>().steps.size(), 6u);
  EXPECT_GT(rig.outcome(id)->detail.as<CycleReport>().steps[0].duration, Duration::zero());
  EXPECT_TRUE(rig.nothingSent());
}

TEST(PickAndPlace, refusesWhatCannotBeACycle) {
  const struct {
    void (*spoil)(PickAndPlaceGoal&);
    int error_id;
    int failed_step = -1;
    const char* words = "";
  } kRows[] = {
      {[](PickAndPlaceGoal& g) { g.steps.clear(); }, own_error::kStepCount, -1, "0 steps; allowed: 1 to 50"},
      {[](PickAndPlaceGoal& g) { g.steps.resize(51, g.steps[0]); }, own_error::kStepCount},
      {[](PickAndPlaceGoal& g) { g.steps_fault = "line 3: no such key"; }, own_error::kStepsUnreadable},
      {[](PickAndPlaceGoal& g) { g.cycles = -1; }, own_error::kCycleRange},
      {[](PickAndPlaceGoal& g) { g.cycles = 1000001; }, own_error::kCycleRange},
      {[](PickAndPlaceGoal& g) { g.steps[2].dwell = -1; }, own_error::kDwellRange, 2},
      {[](PickAndPlaceGoal& g) { g.steps[2].dwell = 3601; }, own_error::kDwellRange, 2},
      {[](PickAndPlaceGoal& g) { g.steps[2].dwell = std::nan(""); }, own_error::kDwellRange, 2},
      {[](PickAndPlaceGoal& g) { g.steps[2].output->module = "Gripper"; }, own_error::kOutputInvalid, 2},
      {[](PickAndPlaceGoal& g) { g.steps[2].output->output = 4; }, own_error::kOutputInvalid, 2},
      {[](PickAndPlaceGoal& g) { g.steps[2].move.blending_enable = true; }, own_error::kBlendBeforeDwell, 2},
      {[](PickAndPlaceGoal& g) { g.steps[3].move.speed = 0; }, own_error::kStepRefused, 3},
      {[](PickAndPlaceGoal& g) { g.buffer_mode = 3; }, own_error::kBufferModeUnknown},
  };
  for (const auto& row : kRows) {
    CoreRig rig;
    rig.connect();
    PickAndPlaceGoal goal = cycle();
    row.spoil(goal);
    const GoalId id = rig.submit(goal);
    ASSERT_NE(rig.outcome(id), nullptr) << row.error_id;
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Rejected);
    EXPECT_EQ(rig.outcome(id)->error_id, row.error_id) << rig.outcome(id)->error_description;
    EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().failed_step, row.failed_step)
        << rig.outcome(id)->error_description;
    EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr(row.words));
  }
}

TEST(PickAndPlace, tellsTheErrorOfAStepThatIsRefused) {
  CoreRig rig;
  rig.connect();
  PickAndPlaceGoal goal = cycle();
  goal.steps[3].move.speed = 0;
  const GoalId id = rig.submit(goal);
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().steps.at(3).error_id, motion_error::kSpeedRangePercent);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("step 4 of 6"));
}

}  // namespace
}  // namespace cobot_command::testing
