// run_program at the wire: a frame leaves with its permit and no earlier, and each part behind it follows.

#include "cobot_command/blocks/run_program.h"

#include "block_goals.h"
#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/blocks/set_output.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RunProgramTest : public ::testing::Test {
 protected:
  RunProgramTest() : rig(std::nullopt, link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
  }
  /// The frame that was sent is accepted, and its end told.
  void drive() {
    rig.reply(rig.takeScript().id);
    rig.tag(rig.latest().open_tags.at(0));
    rig.stream(StatusFrames());
  }
  void passStreaming(Duration duration) { rig.streamFor(duration, StatusFrames(), 500ms); }
  ProgramReport report(GoalId goal) { return rig.outcome(goal)->detail.as<ProgramReport>(); }

  CoreRig rig;
};

TEST_F(RunProgramTest, SendsTheLinesThatWerePermittedAndATagBehindThem) {
  const GoalId goal = rig.submit(RunProgramGoal{});
  const std::string script = rig.takeScript().script;
  EXPECT_THAT(script, HasSubstr(rig.program->frame.lines[0]));
  EXPECT_THAT(script, HasSubstr("QueueTag("));
  rig.reply("1");
  rig.cancel(goal);
  rig.discardSent();
}

TEST_F(RunProgramTest, WaitsForThePermitAsLongAsItTakes) {
  rig.program->is_permitted = false;
  const GoalId goal = rig.submit(RunProgramGoal{});
  passStreaming(100s);
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.outcome(goal), nullptr);

  rig.program->is_permitted = true;
  rig.stream(StatusFrames());
  drive();
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
  EXPECT_EQ(report(goal).cycles_done, 1);
}

TEST_F(RunProgramTest, TellsAtItsEndHowLongItHasWaited) {
  rig.program->waited = {2s, 0s, 3s};
  const GoalId goal = rig.submit(RunProgramGoal{});
  drive();
  EXPECT_THAT(report(goal).waited, ElementsAre(2s, 0s, 3s));
}

TEST_F(RunProgramTest, WaitsForAnotherPermitWhereThatHasEndedBeforeTheGateLooked) {
  rig.program->ends_with_refusal = true;
  rig.gate = [](const Departure& /*departure*/, Instant /*now*/) {
    return Failure{own_error::kSupervisorSilent, "silent", ""};
  };
  const GoalId goal = rig.submit(RunProgramGoal{});
  passStreaming(10s);
  EXPECT_TRUE(rig.nothingSent());
  EXPECT_EQ(rig.outcome(goal), nullptr);

  rig.gate = nullptr;
  rig.program->is_permitted = true;
  rig.stream(StatusFrames());
  drive();
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST_F(RunProgramTest, SetsAnOutputAndDwellsBehindTheFrame) {
  rig.program->frame.output = good<SetOutputGoal>();
  rig.program->frame.dwell = 2;
  const GoalId goal = rig.submit(RunProgramGoal{});
  drive();
  rig.reply(rig.takeScript().id);
  passStreaming(1s);
  EXPECT_EQ(rig.outcome(goal), nullptr) << "it dwells";
  passStreaming(2s);
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done);
}

TEST_F(RunProgramTest, EndsAtOnceWhenItIsCancelledWhileItWaits) {
  rig.program->is_permitted = false;
  const GoalId goal = rig.submit(RunProgramGoal{});
  rig.cancel(goal);
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::CommandAborted);
  EXPECT_EQ(rig.program->ends, 1) << "and the cell is told";
  EXPECT_TRUE(rig.nothingSent());
}

TEST_F(RunProgramTest, DoesNotSayThatItWasCancelledWhenTheStopWasNotConfirmed) {
  const GoalId goal = rig.submit(RunProgramGoal{});
  rig.reply(rig.takeScript().id);
  rig.cancel(goal);
  rig.reply(rig.takeScript().id, false, {1});
  rig.pass(10s);
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Aborted);
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kStepFailed);
  rig.discardSent();
}

TEST_F(RunProgramTest, StopsTheRobotWhereItLeftItsPath) {
  const GoalId goal = rig.submit(RunProgramGoal{});
  rig.reply(rig.takeScript().id);
  rig.program->stops_robot = true;
  rig.program->failed = Failure{own_error::kOffPath, "joint 1 is 3 deg off", ""};
  rig.stream(StatusFrames().moving());
  EXPECT_THAT(rig.takeScript().script, HasSubstr("StopAndClearBuffer"));
  rig.reply("2");
  rig.stream(StatusFrames(), 20);
  ASSERT_TRUE(rig.outcome(goal));
  EXPECT_EQ(rig.outcome(goal)->error_id, own_error::kOffPath);
}

TEST_F(RunProgramTest, GivesUpWhatItHoldsInTheGuideWhenTheNodeEnds) {
  rig.program->is_permitted = false;
  rig.submit(RunProgramGoal{});
  rig.shutDown();
  EXPECT_EQ(rig.program->ends, 1);
}

}  // namespace
}  // namespace cobot_command::testing
