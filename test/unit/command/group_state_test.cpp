// What the state of the group says of link, goals, messages and robot.
#include "exchange_rig.h"
#include "status_frames.h"
#include "streamed_items.h"
#include <gtest/gtest.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using Sequence = GroupState::Sequence;

class GroupStates : public ::testing::Test {
 protected:
  GroupStates() : rig(std::nullopt, link::LinkSettings()) {
    rig.connect();
    rig.status(StatusFrames());
  }
  [[nodiscard]] const GroupState& state() const { return rig.group_state; }
  ExchangeRig rig;
};

TEST(GroupState, isNothingWithoutALink) {
  ExchangeRig rig;
  rig.pass(1s);
  EXPECT_FALSE(rig.group_state.enabled);
  EXPECT_EQ(rig.group_state.ri_state, RiState::NotInitialized);
  EXPECT_TRUE(rig.group_state.in_primary_position);
}

TEST_F(GroupStates, areEnabledOnALinkThatIsReady) {
  EXPECT_TRUE(state().enabled);
  rig.status(StatusFrames().emergencyStop());
  EXPECT_FALSE(state().enabled);
}

TEST_F(GroupStates, tellTheInterface) {
  const GoalId id = rig.exchange();
  EXPECT_EQ(state().ri_state, RiState::Initialized);
  rig.cancel(id);
  EXPECT_EQ(state().ri_state, RiState::NotInitialized);
}

TEST_F(GroupStates, tellWhatIsUnderWayAndHowFullTheQueueIs) {
  EXPECT_EQ(state().sequence, Sequence::Idle);
  for (int i = 0; i < 13; ++i) rig.submit(CoreRig::move(BufferMode::Buffered));
  EXPECT_EQ(state().sequence, Sequence::Executing);
  EXPECT_DOUBLE_EQ(state().queue_usage, 20);
  rig.status(StatusFrames().paused());
  EXPECT_EQ(state().sequence, Sequence::Interrupted);
  rig.status(StatusFrames());
  EXPECT_EQ(state().sequence, Sequence::Executing);
  rig.discardSent();
}

TEST_F(GroupStates, countWhatIsPending) {
  auto wrong = CoreRig::move();
  wrong.speed = 101;
  rig.submit(wrong);
  EXPECT_EQ(state().pending_errors, 1);
  rig.core.reset(rig.now);
  rig.pump();
  EXPECT_EQ(state().pending_errors, 0);
  rig.status(StatusFrames().whole());
  EXPECT_EQ(state().pending_warnings, 0);
  rig.status(StatusFrames().whole().emergencyStop());
  EXPECT_EQ(state().pending_warnings, 1);
}

}  // namespace
}  // namespace cobot_command::testing
