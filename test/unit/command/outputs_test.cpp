// The PLCopen outputs of the blocks in command_status: how long they stand.

#include "core_rig.h"
#include "status_frames.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

/// A motion of the block executes: that is what its outputs tell, whatever other goals of it come and go.
class OutputsOfAMotion : public ::testing::Test {
 protected:
  OutputsOfAMotion() : rig(*arm::ArmModel::named("tm5-900"), link::LinkSettings{}) {
    rig.connect();
    rig.status(StatusFrames());
    MoveAbsoluteGoal goal = CoreRig::move();
    goal.command_id = 7;
    motion = rig.submit(goal);
    rig.reply(rig.takeScript().id);
    rig.status(StatusFrames().moving());
    expectItsOutputs();
  }
  ~OutputsOfAMotion() override { rig.discardSent(); }
  void expectItsOutputs() {
    const BlockOutputs& outputs = rig.outputs(kBlock<MoveAbsoluteGoal>);
    EXPECT_TRUE(outputs.busy);
    EXPECT_TRUE(outputs.active);
    EXPECT_EQ(outputs.command_id_ack, 7);
  }

  CoreRig rig;
  GoalId motion = 0;
};

TEST_F(OutputsOfAMotion, stayBesideACheck) {
  MoveAbsoluteGoal check = CoreRig::move(BufferMode::Buffered);
  check.check_only = true;
  const GoalId goal = rig.submit(check);
  ASSERT_NE(rig.outcome(goal), nullptr);
  EXPECT_EQ(rig.outcome(goal)->ending, Ending::Done) << rig.outcome(goal)->error_description;
  expectItsOutputs();
}

TEST_F(OutputsOfAMotion, stayBesideACancelOfOneThatWaits) {
  const GoalId first = rig.submit(CoreRig::move(BufferMode::Buffered));
  const GoalId second = rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.cancel(second);
  expectItsOutputs();
  rig.cancel(first);
  expectItsOutputs();
}

TEST_F(OutputsOfAMotion, areThoseOfTheNextOneWhenThatBegins) {
  const GoalId next = rig.submit(CoreRig::move(BufferMode::Buffered));
  rig.tag(7);
  rig.status(StatusFrames());
  ASSERT_NE(rig.outcome(motion), nullptr);
  EXPECT_TRUE(rig.accepted(next));
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).active);
  EXPECT_NE(rig.outputs(kBlock<MoveAbsoluteGoal>).command_id_ack, 7);
}

TEST(Outputs, stayAsAGoalEndedUntilTheBlocksNextGoal) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal wrong = CoreRig::move();
  wrong.accel_time = 0;
  rig.submit(wrong);
  rig.pass(3600s);
  rig.submit(ChangeBaseGoal{});
  rig.reply(rig.takeScript().id);
  const BlockOutputs& move = rig.outputs(kBlock<MoveAbsoluteGoal>);
  EXPECT_TRUE(move.error);
  EXPECT_EQ(move.error_id, motion_error::kAccelTimeRange);
  EXPECT_THAT(move.error_description, ::testing::HasSubstr("150~9999"));
  EXPECT_TRUE(rig.outputs(kBlock<ChangeBaseGoal>).done);
  rig.submit(CoreRig::move());
  EXPECT_FALSE(rig.outputs(kBlock<MoveAbsoluteGoal>).error);
  EXPECT_EQ(rig.outputs(kBlock<MoveAbsoluteGoal>).error_description, "");
  EXPECT_TRUE(rig.outputs(kBlock<MoveAbsoluteGoal>).busy);
  EXPECT_TRUE(rig.outputs(kBlock<ChangeBaseGoal>).done);
  rig.discardSent();
}

}  // namespace
}  // namespace cobot_command::testing
