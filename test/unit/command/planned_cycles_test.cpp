// A cycle that is cancelled or finished while its next step is planned, and the one in front moves the robot.

#include "planned_commands.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

/// Its first step is blended, and done; the robot moves, and its second one is planned.
class CycleBetweenTwoSteps : public CommandPlannedBeside {
 protected:
  CycleBetweenTwoSteps() {
    PickAndPlaceGoal goal;
    goal.steps.push_back({blendedTo(20), std::nullopt, std::nullopt, 0});
    goal.steps.push_back({toJoints(40), std::nullopt, std::nullopt, 0});
    cycle = rig.submit(goal);
    rig.finishPlanToSend();  // as a whole
    rig.finishPlanToSend();
    EXPECT_TRUE(isSent("PTP"));
    rig.reply(script.id);
    rig.stream(StatusFrames().at({5, 0, 90, 0, 90, 0}).moving());
    EXPECT_TRUE(rig.isPlanning());
    EXPECT_EQ(rig.outcome(cycle), nullptr);
  }
  GoalId cycle = 0;
};

TEST_F(CycleBetweenTwoSteps, isStoppedByACancelBeforeItEnds) {
  rig.cancel(cycle);
  EXPECT_TRUE(isSent("StopAndClearBuffer"));
  EXPECT_EQ(rig.outcome(cycle), nullptr) << "the robot moves";
  EXPECT_EQ(rig.progress(cycle).back().phase, Phase::Stopping);
  rig.reply(script.id);
  rig.stream(StatusFrames().at({7, 0, 90, 0, 90, 0}), 3);
  EXPECT_EQ(endingOf(cycle), Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(cycle)->error_description, HasSubstr("the robot was stopped"));
  rig.finishPlan();
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CycleBetweenTwoSteps, saysWhenItsStopWasNotConfirmed) {
  rig.cancel(cycle);
  ASSERT_TRUE(isSent("StopAndClearBuffer"));
  rig.reply(script.id, false);
  for (int i = 0; i < 300 && rig.outcome(cycle) == nullptr; ++i) {
    rig.stream(StatusFrames().at({8, 0, 90, 0, 90, 0}).moving(), 1);
  }
  EXPECT_EQ(endingOf(cycle), Ending::Aborted);
  EXPECT_THAT(rig.outcome(cycle)->error_description, HasSubstr("16#225"));
  EXPECT_TRUE(isSent("StopAndClearBuffer")) << "it is tried once more";
}

TEST_F(CycleBetweenTwoSteps, isFinishedBehindTheMotionThatIsUnderWay) {
  rig.core.finish(FinishAfter::Move, rig.now);
  rig.pump();
  EXPECT_EQ(rig.outcome(cycle), nullptr) << "the robot moves";
  rig.finishPlan();
  EXPECT_TRUE(rig.nothingSent()) << "no other step begins";
  rig.stream(StatusFrames().at({20, 0, 90, 0, 90, 0}), 70);
  EXPECT_EQ(endingOf(cycle), Ending::CommandAborted);
  EXPECT_THAT(rig.outcome(cycle)->error_description, HasSubstr("finished on request"));
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(CycleBetweenTwoSteps, endsWithTheStopOfTheStopBlock) {
  const GoalId stop = rig.submit(StopGoal{});
  EXPECT_TRUE(isSent("StopAndClearBuffer"));
  EXPECT_TRUE(rig.nothingSent()) << "one stop is enough";
  rig.reply(script.id);
  rig.stream(StatusFrames().at({7, 0, 90, 0, 90, 0}), 3);
  EXPECT_EQ(endingOf(cycle), Ending::CommandAborted);
  EXPECT_EQ(endingOf(stop), Ending::Done);
}

TEST_F(CycleBetweenTwoSteps, endsWithItsLink) {
  rig.cancel(cycle);
  rig.discardSent();
  rig.close("gone");
  rig.pass(2s);
  EXPECT_EQ(endingOf(cycle), Ending::Aborted);
}

}  // namespace
}  // namespace cobot_command::testing
