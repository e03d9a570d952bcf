// Outputs that are set at once or in their turn, inputs that are waited for, and a cycle that does both.

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using ::testing::HasSubstr;

const SetOutputGoal kAtOnce{0, "EndModule", 2, 1, true};

StatusFrames inputs(bool on) {
  return StatusFrames().input("Ctrl_DI3", on);
}

/// Connected, the input off.
struct Cell : CoreRig {
  Cell() : CoreRig(std::nullopt, link::LinkSettings{}) {
    connect();
    status(inputs(false));
  }
  Ending endingOf(GoalId id) {
    EXPECT_NE(outcome(id), nullptr);
    return outcome(id) == nullptr ? Ending::Rejected : outcome(id)->ending;
  }
  GoalId wait(double timeout = 10, int buffer_mode = 0) {
    return submit(WaitForInputGoal{"ControlBox", 3, true, timeout, buffer_mode});
  }
};

TEST(SetOutputBlock, isDoneAtOnceWhileAMotionIsUnderWay) {
  Cell rig;
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const GoalId output = rig.submit(kAtOnce);
  const auto script = rig.takeScript();
  EXPECT_EQ(script.script, "IO[\"EndModule\"].InstantDO[2]=1");
  rig.reply(script.id);
  EXPECT_EQ(rig.endingOf(output), Ending::Done);
  EXPECT_EQ(rig.outcome(move), nullptr);
}

TEST(SetOutputBlock, waitsItsTurnOtherwise) {
  Cell rig;
  rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(rig.submit(good<SetOutputGoal>()))->error_id, motion_error::kOtherBlockBusy);
  auto later = good<SetOutputGoal>();
  later.buffer_mode = static_cast<int>(BufferMode::Buffered);
  const GoalId output = rig.submit(later);
  EXPECT_TRUE(rig.nothingSent());
  rig.tag(rig.latest().open_tags.at(0));
  rig.status(inputs(false));
  const auto script = rig.takeScript();
  EXPECT_EQ(script.script, "IO[\"EndModule\"].DO[2]=1");
  rig.reply(script.id);
  EXPECT_EQ(rig.endingOf(output), Ending::Done);
}

TEST(SetOutputBlock, isRefusedWithoutALinkThatListensOrInAnEmergencyStop) {
  {
    CoreRig rig(std::nullopt, link::LinkSettings{});
    rig.submit(CoreRig::robot());
    rig.listening = false;
    rig.open();
    EXPECT_EQ(rig.outcome(rig.submit(kAtOnce))->error_id, own_error::kNotListening);
    rig.discardSent();
  }
  Cell rig;
  rig.status(inputs(false).emergencyStop());
  EXPECT_EQ(rig.outcome(rig.submit(kAtOnce))->error_id, own_error::kEmergencyStop);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(SetOutputBlock, leavesTheMotionAloneWhenItIsNotAnswered) {
  Cell rig;
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const GoalId output = rig.submit(kAtOnce);
  rig.takeScript();
  rig.pass(1s);
  EXPECT_EQ(rig.outcome(output)->error_id, motion_error::kReceiveReply);
  EXPECT_EQ(rig.outcome(move), nullptr);
  rig.discardSent();
}

/// The stream goes on, the input off.
void stream(CoreRig& rig, Duration duration) {
  rig.streamFor(duration, inputs(false), 100ms);
}

TEST(WaitForInputBlock, isDoneWithTheFrameThatShowsTheInput) {
  Cell rig;
  const GoalId id = rig.wait();
  EXPECT_TRUE(rig.accepted(id));
  EXPECT_TRUE(rig.outputs(kBlock<WaitForInputGoal>).active);
  stream(rig, 2s);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.status(inputs(true));
  EXPECT_EQ(rig.endingOf(id), Ending::Done);
  EXPECT_GE(*rig.outcome(id)->actual, 2s);
}

TEST(WaitForInputBlock, believesOnlyWhatIsSeenInItsTurn) {
  Cell rig;
  rig.status(inputs(true));
  rig.pass(10ms);
  const GoalId id = rig.wait();
  EXPECT_EQ(rig.outcome(id), nullptr) << "the frame may be older than what was done in front of it";
  rig.pass(5ms);
  rig.status(inputs(true));
  EXPECT_EQ(rig.endingOf(id), Ending::Done);
}

TEST(WaitForInputBlock, saysThatNoFrameCame) {
  Cell rig;
  const GoalId id = rig.wait(0.2);
  rig.pass(200ms);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("no status frame arrived in 0.2 s"));
}

TEST(WaitForInputBlock, holdsBackWhatComesBehindIt) {
  Cell rig;
  rig.wait();
  EXPECT_EQ(rig.outcome(rig.submit(CoreRig::move()))->error_id, motion_error::kOtherBlockBusy);
  rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_TRUE(rig.nothingSent());
  rig.pass(15ms);
  rig.status(inputs(true));
  EXPECT_THAT(rig.takeScript().script, HasSubstr("PTP"));
}

TEST(WaitForInputBlock, takesWhatWaitsBehindItWithItWhenItTimesOut) {
  Cell rig;
  const GoalId id = rig.wait(1);
  const GoalId behind = rig.submit(CoreRig::move(BufferMode::Buffered));
  stream(rig, 900ms);
  rig.pass(99ms);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.pass(1ms);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kInputTimedOut);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("input 3 of ControlBox was off for 1 s"));
  EXPECT_EQ(rig.endingOf(behind), Ending::CommandAborted);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(WaitForInputBlock, hasItsTimeoutHeldByAPause) {
  Cell rig;
  const GoalId id = rig.wait(1);
  rig.status(inputs(false).paused());
  rig.pass(500ms);
  rig.status(inputs(false).paused());
  rig.pass(400ms);
  rig.status(inputs(false));
  rig.pass(300ms);
  rig.status(inputs(false));
  rig.pass(300ms);
  rig.status(inputs(false));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.pass(450ms);
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kInputTimedOut);
}

TEST(WaitForInputBlock, endsWithoutAStopWhenItIsCancelled) {
  Cell rig;
  const GoalId id = rig.wait();
  rig.cancel(id);
  EXPECT_EQ(rig.endingOf(id), Ending::CommandAborted);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(WaitForInputBlock, endsWithAnEmergencyStop) {
  Cell rig;
  const GoalId id = rig.wait();
  rig.status(inputs(false).emergencyStop());
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("emergency stop"));
}

TEST(WaitForInputBlock, saysWhichInputTheStreamDoesNotTell) {
  Cell rig;
  const GoalId id = rig.submit(WaitForInputGoal{"EndModule", 1, true, 0});
  EXPECT_EQ(rig.outcome(id)->error_id, own_error::kInputUnknown);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("input 1 of EndModule"));
}

TEST(WaitForInputBlock, endsWhenItIsToFinishBehindTheMoveAndNotBehindTheCycle) {
  Cell rig;
  const GoalId id = rig.wait();
  rig.core.finish(FinishAfter::Cycle, rig.now);
  rig.pump();
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.core.finish(FinishAfter::Move, rig.now);
  rig.pump();
  EXPECT_EQ(rig.endingOf(id), Ending::CommandAborted);
}

/// A step that sets an output, and waits for an input.
PickAndPlaceGoal gripping(double timeout = 10) {
  PickAndPlaceGoal goal = good<PickAndPlaceGoal>();
  goal.steps[0].input = WaitForInputGoal{"ControlBox", 3, true, timeout};
  goal.steps[0].dwell = 0;
  return goal;
}

/// Its move is done and its output set.
GoalId untilTheInput(CoreRig& rig, const PickAndPlaceGoal& goal) {
  const GoalId id = rig.submit(goal);
  rig.reply(rig.takeScript().id);
  rig.tag(rig.latest().open_tags.at(0));
  rig.status(inputs(false));
  const auto output = rig.takeScript();
  EXPECT_EQ(output.script, "IO[\"EndModule\"].DO[0]=1");
  rig.reply(output.id);
  return id;
}

TEST(CycleWithAnInput, goesOnWhenTheInputComes) {
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping());
  EXPECT_EQ(rig.outcome(id), nullptr);
  EXPECT_THAT(rig.progress(id).back().text, HasSubstr("waits for input 3 of ControlBox to be on"));
  rig.pass(15ms);
  rig.status(inputs(true));
  EXPECT_EQ(rig.endingOf(id), Ending::Done);
}

TEST(CycleWithAnInput, failsAtTheStepWhoseInputDoesNotCome) {
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping(1));
  stream(rig, 1s);
  const Outcome& outcome = *rig.outcome(id);
  EXPECT_EQ(outcome.error_id, own_error::kStepFailed);
  EXPECT_EQ(outcome.detail.as<CycleReport>().failed_step, 0);
  EXPECT_EQ(outcome.detail.as<CycleReport>().steps.at(0).error_id, own_error::kInputTimedOut);
  EXPECT_THAT(outcome.error_description, HasSubstr("the input of step 1 of 1, cycle 1: 16#265"));
}

TEST(CycleWithAnInput, endsInTheWaitWhenItIsCancelledOrTheLinkIsLost) {
  {
    Cell rig;
    const GoalId id = untilTheInput(rig, gripping());
    rig.cancel(id);
    EXPECT_EQ(rig.endingOf(id), Ending::CommandAborted);
    EXPECT_TRUE(rig.nothingSent());
  }
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping());
  rig.close("gone");
  rig.pass(500ms);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
}

TEST(CycleWithAnInput, saysOnceWhyItsLinkWasLost) {
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping());
  rig.close("gone");
  rig.pass(500ms);
  const std::string& text = rig.outcome(id)->error_description;
  const std::string begin = text.substr(0, text.find(':'));
  EXPECT_EQ(text.find(begin), text.rfind(begin)) << text;
  EXPECT_THAT(text, HasSubstr("gone"));
}

TEST(CycleWithAnInput, namesTheStepAtWhichTheEmergencyStopWasPressed) {
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping());
  rig.pass(15ms);
  rig.status(inputs(false).emergencyStop());
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("emergency stop"));
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().failed_step, 0);
}

TEST(CycleWithAnInput, namesTheStepAtWhichTheLinkWasLostAndKeepsThatReason) {
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping());
  rig.close("gone");
  rig.core.finish(FinishAfter::Move, rig.now);
  rig.pump();
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
  EXPECT_EQ(rig.outcome(id)->detail.as<CycleReport>().failed_step, 0);
}

TEST(CycleWithAnInput, endsInTheWaitWhenItIsToFinishBehindTheMove) {
  Cell rig;
  const GoalId id = untilTheInput(rig, gripping());
  rig.core.finish(FinishAfter::Move, rig.now);
  rig.pump();
  EXPECT_EQ(rig.endingOf(id), Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("while it waited for input 3"));
}

TEST(CycleWithAnInput, neitherBlendsNorLeavesTheNodeInFrontOfTheInput) {
  PickAndPlaceGoal goal = gripping();
  goal.steps[0].output.reset();
  goal.steps[0].move.blending_enable = true;
  EXPECT_EQ(errorOf(goal), own_error::kBlendBeforeDwell);
  goal.steps[0].move.blending_enable = false;
  goal.steps[0].move.exit_node = true;
  EXPECT_EQ(errorOf(goal), own_error::kExitBeforeEnd);
}

TEST(ChangeLoadBlock, countsForWhatTheArmCarries) {
  CoreRig rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  rig.submit(ChangeLoadGoal{5, 0});
  rig.reply(rig.takeScript().id);
  ASSERT_FALSE(rig.warnings.empty());
  EXPECT_THAT(rig.warnings.back(), HasSubstr("its load (ChangeLoad) 5 kg, the payload of tm5-900 is 4 kg"));
}

}  // namespace
}  // namespace cobot_command::testing
