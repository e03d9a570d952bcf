// Pause and resume at any moment, beside whatever else is under way.

#include "core_rig.h"
#include "status_frames.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

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
  EXPECT_TRUE(rig.outputs(Block::MoveAbsolute).busy);
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

TEST(ProgramControl, endsWithAnErrorWithoutAReply) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(pause());
  rig.takeScript();
  rig.pass(1s);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kReceiveReply);
  rig.discardSent();
}

TEST(ProgramControl, isRefusedWithoutALink) {
  CoreRig rig;
  EXPECT_EQ(rig.outcome(rig.submit(pause()))->error_id, motion_error::kNotConnected);
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
