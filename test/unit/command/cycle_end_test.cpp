// How a pick-and-place cycle comes to its end: in its own time on request, out of the Listen node, and how
// long it was planned to take.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

/// Two moves; the second has a dwell.
PickAndPlaceGoal cycle(int cycles) {
  PickAndPlaceGoal goal;
  goal.cycles = cycles;
  goal.steps.resize(2);
  for (auto& step : goal.steps) step.move = CoreRig::move();
  goal.steps[1].move.target[2] += 50;
  goal.steps[1].dwell = 2;
  return goal;
}

void move(CoreRig& rig) {
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, HasSubstr("PTP("));
  EXPECT_THAT(script.script, ::testing::Not(HasSubstr("ScriptExit")));
  rig.reply(script.id);
  rig.tag(rig.latest().open_tags.at(0));
}

void runCycle(CoreRig& rig) {
  move(rig);
  move(rig);
  rig.pass(2s);
}

command::FinishReport finish(CoreRig& rig, FinishAfter after) {
  const command::FinishReport found = rig.core.finish(after, rig.now);
  rig.pump();
  return found;
}

TEST(Finish, letsTheMoveOfACycleEndAndNoOtherBegin) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle(0));
  runCycle(rig);
  const auto script = rig.takeScript();
  rig.reply(script.id);
  finish(rig, FinishAfter::Move);
  EXPECT_TRUE(rig.nothingSent()) << "no stop";
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.tag(rig.latest().open_tags.at(0));
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 1);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("finished on request"));
  rig.pass(10s);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(Finish, endsADwellAtOnce) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle(1));
  move(rig);
  move(rig);
  EXPECT_EQ(rig.progress(goal).back().phase, Phase::Dwelling);
  finish(rig, FinishAfter::Move);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
}

TEST(Finish, letsTheCycleEndAndIsThenDone) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle(0));
  runCycle(rig);
  move(rig);
  finish(rig, FinishAfter::Cycle);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  move(rig);
  rig.pass(2s);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 2);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("after cycle 2"));
  EXPECT_TRUE(rig.nothingSent());
}

TEST(Finish, letsASingleMoveBeDoneAndDropsWhatWaits) {
  for (const FinishAfter after : {FinishAfter::Move, FinishAfter::Cycle}) {
    CoreRig rig;
    rig.connect();
    const GoalId running = rig.submit(CoreRig::move());
    rig.reply(rig.takeScript().id);
    const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
    finish(rig, after);
    ASSERT_NE(rig.outcome(waiting), nullptr);
    EXPECT_EQ(rig.outcome(waiting)->ending, Ending::CommandAborted);
    EXPECT_EQ(rig.outcome(running), nullptr);
    rig.tag(1);
    EXPECT_EQ(rig.outcome(running)->ending, Ending::Done);
    EXPECT_TRUE(rig.nothingSent());
  }
}

TEST(Finish, changesNothingWhenNothingIsUnderWay) {
  CoreRig rig;
  EXPECT_FALSE(finish(rig, FinishAfter::Move).foundAny());
  rig.connect();
  const command::FinishReport nothing = finish(rig, FinishAfter::Cycle);
  EXPECT_FALSE(nothing.foundAny());
  EXPECT_EQ(toText(nothing), "nothing is running");
  const GoalId goal = rig.submit(cycle(2));
  runCycle(rig);
  runCycle(rig);
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 2);
}

TEST(Finish, leavesWhatWasReceivedAfterIt) {
  CoreRig rig;
  rig.connect();
  const GoalId first = rig.submit(CoreRig::move());
  MoveAbsoluteGoal next = CoreRig::move(BufferMode::Buffered);
  next.target[0] += 5;
  const GoalId before = rig.submit(next);
  const GoalId after = rig.submit(next);
  const command::FinishReport found = rig.core.finish(FinishAfter::Move, rig.now, before);
  rig.pump();
  EXPECT_EQ(found.dropped, 1);
  ASSERT_NE(rig.outcome(before), nullptr);
  EXPECT_EQ(rig.outcome(before)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.outcome(after), nullptr);
  move(rig);
  EXPECT_EQ(rig.outcome(first)->ending, Ending::Done);
  move(rig);
  EXPECT_EQ(rig.outcome(after)->ending, Ending::Done);
}

TEST(Finish, tellsWhatItHasFound) {
  CoreRig rig;
  rig.connect();
  rig.submit(CoreRig::blended());
  rig.reply(rig.takeScript().id);
  const command::FinishReport loose = finish(rig, FinishAfter::Move);
  EXPECT_FALSE(loose.foundAny());
  EXPECT_THAT(toText(loose), HasSubstr("nothing is running; motions whose goals have ended may still move"));

  rig.submit(CoreRig::move());
  rig.submit(CoreRig::move(BufferMode::Buffered));
  const command::FinishReport one = finish(rig, FinishAfter::Move);
  EXPECT_TRUE(one.foundAny());
  EXPECT_EQ(toText(one),
            "move_absolute runs to its end; see its own result; one goal in the queue has ended");
  rig.reply(rig.takeScript().id);
  rig.tag(rig.latest().open_tags.at(0));

  rig.submit(cycle(0));
  EXPECT_EQ(finish(rig, FinishAfter::Cycle).under_way, kBlock<PickAndPlaceGoal>);
  rig.shutDown();
  rig.discardSent();
}

TEST(Finish, canStillBeFollowedByACancelThatStops) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(cycle(0));
  rig.reply(rig.takeScript().id);
  finish(rig, FinishAfter::Cycle);
  rig.cancel(goal);
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
}

TEST(CycleExit, comesBehindTheLastStepOfTheLastCycleOnly) {
  CoreRig rig;
  rig.connect();
  PickAndPlaceGoal goal = cycle(2);
  goal.steps[1].move.exit_node = true;
  const GoalId id = rig.submit(goal);
  runCycle(rig);
  move(rig);
  move(rig);
  const auto exit = rig.takeScript();
  EXPECT_EQ(exit.script, "ScriptExit()");
  rig.reply(exit.id);
  rig.pass(2s);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().cycles_done, 2);
}

PickAndPlaceGoal leavingCycle(int cycles) {
  PickAndPlaceGoal goal = cycle(cycles);
  goal.steps[1].move.exit_node = true;
  return goal;
}

GoalId dwellBehindLastStep(CoreRig& rig) {
  rig.connect();
  const GoalId goal = rig.submit(leavingCycle(3));
  move(rig);
  move(rig);
  return goal;
}

void expectExit(CoreRig& rig) {
  const auto exit = rig.takeScript();
  EXPECT_EQ(exit.script, "ScriptExit()");
  rig.reply(exit.id);
}

TEST(CycleExit, comesBehindTheMoveThatFinishMakesTheLastWhileItIsUnderWay) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(leavingCycle(3));
  move(rig);
  rig.reply(rig.takeScript().id);
  finish(rig, FinishAfter::Cycle);
  rig.tag(rig.latest().open_tags.at(0));
  expectExit(rig);
  rig.pass(2s);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().cycles_done, 1);
}

TEST(CycleExit, comesInTheDwellThatFinishMakesTheLast) {
  CoreRig rig;
  const GoalId goal = dwellBehindLastStep(rig);
  rig.pass(500ms);
  EXPECT_TRUE(rig.nothingSent());
  finish(rig, FinishAfter::Cycle);
  expectExit(rig);
  rig.pass(1400ms);
  EXPECT_EQ(rig.outcome(goal), nullptr) << "the dwell is as long as ever";
  rig.pass(100ms);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
  EXPECT_TRUE(rig.nothingSent());
}

TEST(CycleExit, isAwaitedByTheEndOfTheDwell) {
  CoreRig rig;
  const GoalId goal = dwellBehindLastStep(rig);
  rig.pass(1900ms);
  finish(rig, FinishAfter::Cycle);
  const auto exit = rig.takeScript();
  rig.pass(500ms);
  EXPECT_EQ(rig.outcome(goal), nullptr);
  rig.reply(exit.id);
  rig.pass(0s);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST(CycleExit, failsTheStepWhenItIsNotTakenInTheDwell) {
  CoreRig rig;
  const GoalId goal = dwellBehindLastStep(rig);
  finish(rig, FinishAfter::Cycle);
  rig.reply(rig.takeScript().id, false, {1});
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kStepFailed);
  EXPECT_EQ(rig.outcome(goal)->detail.as<CycleReport>().failed_step, 1);
}

TEST(CycleExit, isNotSentInTheDwellWhenTheFlowHasLeftByItself) {
  CoreRig rig;
  const GoalId goal = dwellBehindLastStep(rig);
  rig.listening = false;
  rig.pass(1s);
  finish(rig, FinishAfter::Cycle);
  EXPECT_TRUE(rig.nothingSent());
  rig.pass(1s);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
}

TEST(CycleExit, isNotBegunBehindTheMoveThatWasToBeTheLastThing) {
  CoreRig rig;
  rig.connect();
  const GoalId goal = rig.submit(leavingCycle(1));
  move(rig);
  rig.reply(rig.takeScript().id);
  finish(rig, FinishAfter::Move);
  rig.tag(rig.latest().open_tags.at(0));
  EXPECT_TRUE(rig.nothingSent());
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
}

/// A cycle between two commands whose link was lost: the status stream may tell why.
GoalId loseLinkInDwell(CoreRig& rig) {
  rig.connect();
  const GoalId goal = rig.submit(cycle(0));
  move(rig);
  move(rig);
  rig.close("peer gone");
  EXPECT_EQ(rig.outcome(goal), nullptr) << "it still looks for the reason";
  return goal;
}

TEST(CycleEnd, isTheLossOfTheLinkAlsoWhenItIsCancelledMeanwhile) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  const GoalId goal = loseLinkInDwell(rig);
  rig.cancel(goal);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, motion_error::kLinkDropped);
}

TEST(CycleEnd, isTheLossOfTheLinkAlsoWhenItIsToBeFinishedMeanwhile) {
  for (const FinishAfter after : {FinishAfter::Move, FinishAfter::Cycle}) {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    const GoalId goal = loseLinkInDwell(rig);
    finish(rig, after);
    rig.pass(10s);
    ASSERT_NE(rig.outcome(goal), nullptr);
    EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
    EXPECT_EQ(rig.outcome(goal)->error_id, motion_error::kLinkDropped);
  }
}

TEST(CycleEnd, tellsTheFirstCancelWhileAnOutputIsUnderWayWhateverIsAskedBehindIt) {
  CoreRig rig;
  rig.connect();
  PickAndPlaceGoal goal = cycle(0);
  goal.steps[0].output = SetOutputGoal{0, "EndModule", 0, 1};
  const GoalId id = rig.submit(goal);
  move(rig);
  const auto output = rig.takeScript();
  finish(rig, FinishAfter::Move);
  rig.cancel(id);
  finish(rig, FinishAfter::Move);
  finish(rig, FinishAfter::Cycle);
  rig.discardSent();
  rig.reply(output.id);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("cancelled; no motion was running"));
}

TEST(CycleExit, isRefusedBeforeTheFirstMoveWhereItWouldBreakTheCycle) {
  const std::vector<void (*)(PickAndPlaceGoal&)> spoilt = {
      [](PickAndPlaceGoal& g) { g.steps[0].move.exit_node = true; },
      [](PickAndPlaceGoal& g) {
        g.steps[1].move.exit_node = true;
        g.cycles = 0;
      },
      [](PickAndPlaceGoal& g) {
        g.steps[1].move.exit_node = true;
        g.steps[1].output = SetOutputGoal{0, "EndModule", 0, 1};
      },
  };
  for (const auto& spoil : spoilt) {
    CoreRig rig;
    rig.connect();
    PickAndPlaceGoal goal = cycle(1);
    spoil(goal);
    const GoalId id = rig.submit(goal);
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Rejected);
    EXPECT_EQ(rig.outcome(id)->error_id, own_error::kExitBeforeEnd);
    EXPECT_TRUE(rig.nothingSent());
  }
}

TEST(CycleDuration, isThatOfOneCycleWithItsDwellsHoweverManyThereAre) {
  std::optional<Duration> alone;
  for (const int cycles : {1, 3}) {
    CoreRig rig(arm::ArmModel::named("tm5-900").value(), link::LinkSettings{});
    rig.connect();
    rig.status(StatusFrames());
    PickAndPlaceGoal goal = cycle(cycles);
    goal.check_only = true;
    const Outcome checked = *rig.outcome(rig.submit(goal));
    const StepReport& last = checked.detail.as<CycleReport>().steps.at(1);
    const Duration expected = last.start + last.duration + 2s;
    EXPECT_EQ(checked.planned, expected);
    if (!alone) alone = checked.planned;
    EXPECT_EQ(checked.planned, alone);

    goal.check_only = false;
    const GoalId id = rig.submit(goal);
    rig.cancel(id);
    rig.discardSent();
    rig.submit(StopGoal{});
    rig.discardSent();
    rig.shutDown();
    rig.discardSent();
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->planned, expected) << "also when it ran";
  }
}

TEST(CycleDuration, isAbsentWhenItCouldNotBePlanned) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(cycle(1));
  runCycle(rig);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(id)->planned, std::nullopt);
}

}  // namespace
}  // namespace cobot_command::testing
