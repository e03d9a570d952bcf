// The PLCopen outputs of the blocks in command_status: how long they stand.

#include "core_rig.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;

TEST(Outputs, stayAsAGoalEndedUntilTheBlocksNextGoal) {
  CoreRig rig;
  rig.connect();
  MoveAbsoluteGoal wrong = CoreRig::move();
  wrong.accel_time = 0;
  rig.submit(wrong);
  rig.pass(3600s);
  rig.submit(ChangeBaseGoal{});
  rig.reply(rig.takeScript().id);
  const BlockOutputs& move = rig.outputs(Block::MoveAbsolute);
  EXPECT_TRUE(move.error);
  EXPECT_EQ(move.error_id, motion_error::kAccelTimeRange);
  EXPECT_THAT(move.error_description, ::testing::HasSubstr("150~9999"));
  EXPECT_TRUE(rig.outputs(Block::ChangeBase).done);
  rig.submit(CoreRig::move());
  EXPECT_FALSE(rig.outputs(Block::MoveAbsolute).error);
  EXPECT_EQ(rig.outputs(Block::MoveAbsolute).error_description, "");
  EXPECT_TRUE(rig.outputs(Block::MoveAbsolute).busy);
  EXPECT_TRUE(rig.outputs(Block::ChangeBase).done);
  rig.discardSent();
}

}  // namespace
}  // namespace cobot_command::testing
