// Pause and resume at any moment, beside whatever else is under way.

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

ProgramControlGoal pause() {
  return {0, static_cast<int>(ProgramCommand::Pause)};
}
ProgramControlGoal resume() {
  return {0, static_cast<int>(ProgramCommand::Resume)};
}

TEST(ProgramControl, isDoneWhenTheControllerAcceptedIt) {
  CoreRig rig;
  rig.connect();
  for (const auto& [goal, text] : {std::pair(pause(), "Pause()"), std::pair(resume(), "Resume()")}) {
    const GoalId id = rig.submit(goal);
    const auto script = rig.takeScript();
    EXPECT_EQ(script.script, text);
    EXPECT_EQ(rig.outcome(id), nullptr);
    rig.reply(script.id);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  }
}

TEST(ProgramControl, goesOutWhileAMotionIsUnderWay) {
  CoreRig rig;
  rig.connect();
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const GoalId id = rig.submit(pause());
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(move), nullptr);
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  rig.tag(rig.latest().open_tags.at(0));
  EXPECT_EQ(rig.outcome(move)->ending, Ending::Done);
}

TEST(ProgramControl, twiceAtOnceEachGetsItsOwnAnswer) {
  CoreRig rig;
  rig.connect();
  const GoalId first = rig.submit(pause());
  const GoalId second = rig.submit(resume());
  const auto one = rig.takeScript();
  const auto two = rig.takeScript();
  rig.reply(two.id, false, {1});
  EXPECT_EQ(rig.outcome(second)->error_id, motion_error::kRejected);
  rig.reply(one.id);
  EXPECT_EQ(rig.outcome(first)->ending, Ending::Done);
}

/// Nobody knows whether the robot is paused: the stop takes the motion away, which says for what.
TEST(ProgramControl, withoutAReplyStopsTheMotionThatIsUnderWayAndWhatWaits) {
  CoreRig rig;
  rig.connect();
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
  const GoalId id = rig.submit(pause());
  rig.takeScript();
  rig.pass(1s);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kReceiveReply);
  EXPECT_EQ(rig.outcome(waiting)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.outcome(move), nullptr) << "not before the robot stands";
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  EXPECT_TRUE(rig.nothingSent()) << "one frame is enough";
  rig.reply(stop.id);
  ASSERT_NE(rig.outcome(move), nullptr);
  EXPECT_EQ(rig.outcome(move)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(move)->error_description,
              HasSubstr("stopped, because program_control got no reply"));
}

TEST(ProgramControl, withoutAReplyStopsACycleInItsDwellToo) {
  CoreRig rig;
  rig.connect();
  const GoalId cycle = rig.submit(with<PickAndPlaceGoal>([](auto& g) { g.steps[0].output.reset(); }));
  rig.reply(rig.takeScript().id);
  rig.tag(1);
  rig.submit(pause());
  rig.takeScript();
  rig.pass(1s);
  EXPECT_EQ(rig.takeScript().script, "StopAndClearBuffer()");
  ASSERT_NE(rig.outcome(cycle), nullptr);
  EXPECT_EQ(rig.outcome(cycle)->ending, Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(cycle)->error_description, HasSubstr("program_control got no reply"));
}

TEST(ProgramControl, endsWithAnEmergencyStop) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId id = rig.submit(pause());
  rig.takeScript();
  rig.status(StatusFrames().emergencyStop());
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("emergency stop"));
}

TEST(ProgramControl, isNotHeldBackByAnErrorOrAPause) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  for (const auto& frame : {StatusFrames().error(0x13, "PTP"), StatusFrames().paused()}) {
    rig.status(frame);
    const GoalId id = rig.submit(resume());
    rig.status(frame);
    rig.reply(rig.takeScript().id);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  }
}

TEST(ProgramControl, isLeftToTheControllerOutsideTheListenNode) {
  CoreRig rig;
  rig.connect();
  rig.submit(ExitListenNodeGoal{});
  rig.reply(rig.takeScript().id);
  const GoalId taken = rig.submit(pause());
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(taken)->ending, Ending::Done);
  const GoalId refused = rig.submit(pause());
  rig.takeScript();
  rig.say(protocol::CommunicationError{protocol::CommunicationErrorCode::NotListening});
  EXPECT_EQ(rig.outcome(refused)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(refused)->error_id, own_error::kNotListening);
}

TEST(ProgramControl, endsWithAConnectionThatWasNeverEstablished) {
  CoreRig rig;
  rig.answers_lifesigns = false;
  rig.submit(CoreRig::robot());
  rig.open();
  const GoalId id = rig.submit(pause());
  rig.discardSent();
  rig.close("gone");
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kLinkDropped);
}

TEST(ProgramControl, showsTheHoldInTheFeedbackOfTheMotion) {
  CoreRig rig(std::nullopt, link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames());
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().paused());
  EXPECT_EQ(rig.progress(move).back().phase, Phase::Held);
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.progress(move).back().phase, Phase::Active);
  rig.tag(rig.latest().open_tags.at(0));
}

}  // namespace
}  // namespace cobot_command::testing
