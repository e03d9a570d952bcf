// A controller that falls silent with its connection open, at whatever moment: found within 3 s by its
// lifesigns, and with it everything ends.
#include "core_rig.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/error_ids.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

class DeadPeer : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(SilentForMs, DeadPeer, ::testing::Values(0, 1, 250, 500, 999));

TEST_P(DeadPeer, isFoundWithinThreeSecondsAndEverythingEndsInTheSameEvent) {
  link::LinkSettings settings = CoreRig::noStatus();
  settings.reply_timeout = 10s;  // what is open shall end by the loss, not by its own deadline
  CoreRig rig(std::nullopt, settings);
  const GoalId connect = rig.connect();
  rig.pass(1s + std::chrono::milliseconds(GetParam()));  // somewhere between two lifesigns
  const GoalId motion = rig.submit(CoreRig::move());
  const GoalId waiting = rig.submit(CoreRig::move(BufferMode::Buffered));
  const GoalId pause = rig.submit(ProgramControlGoal{});
  rig.discardSent();

  rig.answers_lifesigns = false;
  const Instant silent = rig.now;
  while (rig.outcome(connect) == nullptr && rig.now < silent + 10s) {
    for (const GoalId goal : {motion, waiting, pause}) {
      ASSERT_EQ(rig.outcome(goal), nullptr) << "goal " << goal << " ended before the loss";
    }
    rig.pass(1ms);
  }
  EXPECT_LE(rig.now - silent, 3s);
  for (const GoalId goal : {connect, motion, waiting, pause}) {
    EXPECT_NE(rig.outcome(goal), nullptr) << "goal " << goal << " outlives the link";
  }
  EXPECT_EQ(rig.outcome(motion)->error_id, motion_error::kLinkDropped);
  rig.discardSent();
}

}  // namespace
}  // namespace cobot_command::testing
