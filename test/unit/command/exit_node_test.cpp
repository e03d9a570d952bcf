// A motion with exit_node: the node is left behind it, and until it is done the robot can be stopped.

#include "block_goals.h"
#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::EndsWith;
using ::testing::HasSubstr;

MoveAbsoluteGoal leaving() {
  MoveAbsoluteGoal goal = CoreRig::move();
  goal.exit_node = true;
  return goal;
}

GoalId start(CoreRig& rig, const Goal& goal) {
  const GoalId id = rig.submit(goal);
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, ::testing::Not(HasSubstr("ScriptExit")));
  rig.reply(script.id);
  return id;
}

TEST(ExitNode, leavesAMotionThatCanBeCancelledAndThenLeavesNothing) {
  CoreRig rig;
  rig.connect();
  const GoalId id = start(rig, leaving());
  rig.cancel(id);
  const auto stop = rig.takeScript();
  EXPECT_EQ(stop.script, "StopAndClearBuffer()");
  rig.reply(stop.id);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::Ready);
}

TEST(ExitNode, leavesAMotionThatCanBeStoppedAndPaused) {
  CoreRig rig;
  rig.connect();
  const GoalId id = start(rig, leaving());
  const GoalId pause = rig.submit(ProgramControlGoal{});
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(pause)->ending, Ending::Done);
  const GoalId stop = rig.submit(StopGoal{});
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(stop)->ending, Ending::Done);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::CommandAborted);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(ExitNode, isDoneWithBlendingWhenTheMotionIsAndNotAtItsAcceptance) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = leaving();
  goal.blending_enable = true;
  goal.blending_value = 50;
  const GoalId id = start(rig, goal);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.tag(rig.latest().open_tags.at(0));
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

TEST(ExitNode, tellsOfTheMotionInItsResult) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal goal = leaving();
  goal.command_id = 7;
  const GoalId id = start(rig, goal);
  rig.pass(500ms);
  rig.tag(7);
  rig.pass(300ms);
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(id)->command_id_ack, 7);
  EXPECT_EQ(rig.outcome(id)->actual, 500ms) << "the exit is no part of the motion";
}

TEST(ExitNode, isAnErrorWhenTheExitIsNotTaken) {
  CoreRig rig;
  rig.connect();
  const GoalId id = start(rig, leaving());
  rig.tag(1);
  rig.reply(rig.takeScript().id, false, {1});
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(id)->error_id, motion_error::kRejected);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("the motion was done"));
}

TEST(ExitNode, needsNoExitWhenTheFlowHasLeftByItself) {
  CoreRig rig;
  rig.connect();
  const GoalId id = start(rig, leaving());
  rig.listening = false;
  rig.pass(1s);
  rig.tag(1);
  ASSERT_NE(rig.outcome(id), nullptr);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  EXPECT_TRUE(rig.nothingSent());
}

TEST(ExitNode, cannotBeCancelledOnceTheMotionIsDone) {
  CoreRig rig;
  rig.connect();
  const GoalId id = start(rig, leaving());
  rig.tag(1);
  const auto exit = rig.takeScript();
  rig.cancel(id);
  EXPECT_TRUE(rig.nothingSent());
  rig.reply(exit.id);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

TEST(ExitNode, comesBehindTheTagOfARawScriptToo) {
  CoreRig rig;
  rig.connect();
  RunScriptGoal goal = good<RunScriptGoal>();
  goal.script += "\r\nScriptExit()";
  goal.await_motion = true;
  const GoalId id = start(rig, goal);
  rig.tag(1);
  const auto exit = rig.takeScript();
  EXPECT_EQ(exit.script, "ScriptExit()");
  rig.reply(exit.id);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

TEST(ExitNode, isKnownOfAScriptThatLeavesByANumberToo) {
  CoreRig rig;
  rig.connect();
  RunScriptGoal goal;
  goal.script = "ScriptExit(0)";
  const GoalId id = rig.submit(goal);
  rig.reply(rig.takeScript().id);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
  EXPECT_EQ(rig.latest().link, CommandStatus::LinkState::NotListening);
}

TEST(ExitNode, goesWithTheScriptOfACommandThatDoesNotWaitForMotion) {
  CoreRig rig;
  rig.connect();
  const GoalId id = rig.submit(with<ChangeBaseGoal>([](auto& g) { g.exit_node = true; }));
  const auto script = rig.takeScript();
  EXPECT_THAT(script.script, EndsWith("\r\nScriptExit()"));
  rig.reply(script.id);
  EXPECT_EQ(rig.outcome(id)->ending, Ending::Done);
}

}  // namespace
}  // namespace cobot_command::testing
