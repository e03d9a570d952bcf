// The gate: asked before the first byte of a frame that may move the robot.

#include "block_goals.h"
#include "core_rig.h"
#include "motion_goals.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class GateTest : public ::testing::Test {
 protected:
  GateTest() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    rig.gate = [this](const Departure& departure, Instant /*now*/) -> std::optional<Failure> {
      asked.push_back(departure);
      if (asked.size() < closed_from) return std::nullopt;
      return Failure{own_error::kOrphanMoves, "the gate is closed", ""};
    };
    rig.connect();
    rig.status(StatusFrames());
  }
  void closeFrom(std::size_t departure) { closed_from = departure; }

  std::vector<Departure> asked;
  std::size_t closed_from = 1000;
  CoreRig rig;
};

TEST_F(GateTest, isToldWhatWillMoveTheRobotBeforeItLeaves) {
  rig.submit(testing::moveJoints({60, 0, 90, 0, 90, 0}));
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].block, kBlock<MoveAbsoluteGoal>);
  EXPECT_TRUE(asked[0].planned);
  EXPECT_EQ(asked[0].motions.size(), 1U);
  EXPECT_THAT(asked[0].lines, ElementsAre(HasSubstr("PTP(\"JPP\""))) << "without tag and exit";
  rig.takeScript();
}

TEST_F(GateTest, keepsAMoveBackWithTheReasonOfWhoClosedIt) {
  closeFrom(1);
  const GoalId goal = rig.submit(testing::moveJoints({60, 0, 90, 0, 90, 0}));
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Rejected);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kOrphanMoves);
  EXPECT_THAT(rig.outcome(goal)->error_description, HasSubstr("the gate is closed"));
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_TRUE(rig.latest().open_tags.empty());
}

TEST_F(GateTest, isAskedForEachMoveOfACycle) {
  PickAndPlaceGoal cycle;
  cycle.cycles = 1;
  for (const double joint : {60.0, -30.0}) {
    PickAndPlaceStep step;
    step.move = testing::moveJoints({joint, 0, 90, 0, 90, 0});
    cycle.steps.push_back(step);
  }
  closeFrom(2);
  const GoalId goal = rig.submit(cycle);
  rig.reply(rig.takeScript().id);
  rig.tag(rig.latest().open_tags.at(0));
  rig.stream(StatusFrames().at({60, 0, 90, 0, 90, 0}));
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kStepRefused);
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(GateTest, isAskedForAScriptOfWhichNobodyKnowsWhatItDoes) {
  closeFrom(1);
  RunScriptGoal script;
  script.script = "Frobnicate(1)";
  const GoalId goal = rig.submit(script);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_FALSE(asked[0].planned);
  EXPECT_TRUE(rig.outcome(goal));
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(GateTest, isAskedForWhatSetsTheArmInMotionWithoutAMotionOfItsOwn) {
  closeFrom(1);
  for (const char* lines : {"ContinueVJog()\r\nSetContinueVJog(10,0,0,0,0,0)",
                            "SetContinueVJog(10,0,0,0,0,0)", "Resume()", "PVTResume()"}) {
    asked.clear();
    RunScriptGoal script;
    script.script = lines;
    const GoalId goal = rig.submit(script);
    EXPECT_EQ(asked.size(), 1U) << lines;
    EXPECT_NE(rig.outcome(goal), nullptr) << lines;
    EXPECT_TRUE(rig.nothingSent()) << lines;
  }
}

TEST_F(GateTest, isAskedForAnExitFromTheNodeAsTheProjectGoesOnThen) {
  closeFrom(1);
  RunScriptGoal script;
  script.script = "ScriptExit(1)";
  MoveAbsoluteGoal move = testing::moveJoints({60, 0, 90, 0, 90, 0});
  move.exit_node = true;
  for (const Goal& goal : {Goal(ExitListenNodeGoal()), Goal(script), Goal(move)}) {
    asked.clear();
    const GoalId id = rig.submit(goal);
    ASSERT_EQ(asked.size(), 1U) << toString(blockOf(goal));
    EXPECT_TRUE(asked[0].leaves_node);
    EXPECT_NE(rig.outcome(id), nullptr);
    EXPECT_TRUE(rig.nothingSent());
  }
}

TEST_F(GateTest, isNotAskedForWhatMovesNothing) {
  closeFrom(1);
  ChangeBaseGoal base;
  rig.submit(base);
  rig.reply(rig.takeScript().id);
  EXPECT_TRUE(asked.empty());
}

TEST_F(GateTest, isNotAskedForAStopAPauseOrAResume) {
  closeFrom(1);
  rig.submit(StopGoal{});
  EXPECT_THAT(rig.takeScript().script, HasSubstr("StopAndClearBuffer"));
  ProgramControlGoal pause;
  pause.command = static_cast<int>(ProgramCommand::Pause);
  rig.submit(pause);
  EXPECT_THAT(rig.takeScript().script, HasSubstr("Pause"));
  ProgramControlGoal resume;
  resume.command = static_cast<int>(ProgramCommand::Resume);
  rig.submit(resume);
  EXPECT_THAT(rig.takeScript().script, HasSubstr("Resume"));
  EXPECT_TRUE(asked.empty());
}

}  // namespace
}  // namespace cobot_command::testing
