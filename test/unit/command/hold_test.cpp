// A motion that is held is told as held, with what holds it and what lets it go on.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

RunScriptGoal pausing() {
  RunScriptGoal goal;
  goal.script = "Pause()\r\nPTP(\"JPP\",10,0,90,0,90,0,30,300,0,false)";
  goal.await_motion = true;
  return goal;
}

class Hold : public ::testing::Test {
 protected:
  Hold() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
  }
  void expectHeld(GoalId id, const ::testing::Matcher<const std::string&>& words) {
    ASSERT_FALSE(rig.progress(id).empty());
    EXPECT_EQ(rig.progress(id).back().phase, Phase::Held);
    EXPECT_THAT(rig.progress(id).back().text, words);
  }
  void endIt(GoalId id) {
    rig.tag(rig.latest().open_tags.at(0));
    rig.status(StatusFrames().at({10, 0, 90, 0, 90, 0}));
    ASSERT_NE(rig.outcome(id), nullptr);
    EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
  }
  CoreRig rig;
};

TEST_F(Hold, byAPauseInTheScriptTellsWhatContinuesIt) {
  const GoalId id = rig.submit(pausing());
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().paused());
  expectHeld(id, AllOf(HasSubstr("paused by a Pause() in the script"), HasSubstr("program_control")));
  EXPECT_THAT(rig.latest().diagnosis, HasSubstr("the project is paused"));
  for (int i = 0; i < 700; ++i) {
    rig.pass(500ms);
    rig.status(StatusFrames().paused());
  }
  EXPECT_EQ(rig.outcome(id), nullptr) << "it has its time back";
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.progress(id).back().phase, Phase::Active);
  endIt(id);
}

TEST_F(Hold, byAPauseThatTheScriptDoesNotHaveIsTheProjects) {
  RunScriptGoal script = pausing();
  script.script = "float PVTPause_ = 1\r\nPVTPause()\r\nPTP(\"JPP\",10,0,90,0,90,0,30,300,0,false)";
  const GoalId id = rig.submit(script);
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().paused());
  expectHeld(id, AllOf(HasSubstr("the project is paused"), HasSubstr("program_control"),
                       Not(HasSubstr("in the script"))));
  endIt(id);
}

TEST_F(Hold, byASafeguardTellsSo) {
  const GoalId id = rig.submit(pausing());
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().with(protocol::item::ofBool("Safeguard_A", true)));
  expectHeld(id, HasSubstr("stopped by a safeguard"));
  endIt(id);
}

/// The stream may show the pause before the script port has its OK.
TEST_F(Hold, thatBeganBeforeTheAcceptanceIsToldAndTakesNoTime) {
  const GoalId id = rig.submit(pausing());
  const auto script = rig.takeScript();
  rig.status(StatusFrames().paused());
  rig.pass(900ms);
  rig.status(StatusFrames().paused());
  rig.reply(script.id);
  rig.status(StatusFrames().paused());
  expectHeld(id, HasSubstr("Pause()"));
  rig.pass(500ms);
  rig.status(StatusFrames());
  const Progress going = rig.progress(id).back();
  EXPECT_EQ(going.phase, Phase::Active);
  EXPECT_EQ(going.remaining, going.planned) << "it begins now";
  rig.pass(150ms);
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.progress(id).back().remaining, *going.planned - 150ms);
  endIt(id);
}

/// What is held is the motion in front of it, which was done for its goal when it was accepted.
TEST_F(Hold, inFrontOfAMotionThatWaitsForAnotherIsToldToo) {
  RunScriptGoal front = pausing();
  front.await_motion = false;
  rig.submit(front);
  rig.reply(rig.takeScript().id);
  rig.status(StatusFrames().paused());
  RunScriptGoal second = pausing();
  second.script = "PTP(\"JPP\",20,0,90,0,90,0,30,300,0,false)";
  const GoalId id = rig.submit(second);
  rig.reply(rig.takeScript().id);
  expectHeld(id, HasSubstr("the motion before it"));
  for (int i = 0; i < 40; ++i) {
    rig.pass(500ms);
    rig.status(StatusFrames().paused());
  }
  expectHeld(id, AllOf(HasSubstr("the motion before it"), HasSubstr("the project is paused"),
                       HasSubstr("program_control")));
  EXPECT_FALSE(rig.outputs(kBlock<RunScriptGoal>).active) << "nothing of it is executed";
  rig.status(StatusFrames().moving());
  EXPECT_EQ(rig.progress(id).back().phase, Phase::Queued) << "its turn is still to come";
  EXPECT_FALSE(rig.outputs(kBlock<RunScriptGoal>).active);
  for (int i = 0; i < 4; ++i) {
    rig.pass(500ms);
    rig.status(StatusFrames().moving());
  }
  EXPECT_EQ(rig.progress(id).back().phase, Phase::Active);
  rig.tag(rig.latest().open_tags.at(0));
  rig.status(StatusFrames().at({20, 0, 90, 0, 90, 0}));
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done) << rig.outcome(id)->error_description;
}

TEST_F(Hold, byAPauseThatTheStreamDoesNotShowIsToldWithTheAcceptance) {
  rig.status(StatusFrames().without("Project_Pause"));
  const GoalId id = rig.submit(pausing());
  rig.reply(rig.takeScript().id);
  EXPECT_THAT(rig.progress(id).back().text,
              AllOf(HasSubstr("Pause() in the script"), HasSubstr("program_control")));
  endIt(id);
}

}  // namespace
}  // namespace cobot_command::testing
