// The tables of the two kinds of goals.

#include "table_checks.h"
#include <gtest/gtest.h>

#include "cobot_command/blocks/connect_run_states.h"
#include "cobot_command/blocks/motion_run_states.h"

namespace cobot_command::blocks {
namespace {

using testing::allUpTo;
using testing::expectSoundTable;

TEST(MotionRunTable, isSound) {
  expectSoundTable<MotionRunTable>(MotionRunState::Ended, MotionRunEvent::Standing, MotionRunState::Sent,
                                   {MotionRunState::Ended});
}

TEST(ConnectTable, isSound) {
  expectSoundTable<ConnectTable>(ConnectState::Disconnecting, ConnectEvent::MotionsEnded, ConnectState::Idle);
}

TEST(MotionRunTable, endsOnAFailureInEveryState) {
  for (const auto state : allUpTo(MotionRunState::Settling)) {
    const auto row = link::findTransition<MotionRunTable>(state, MotionRunEvent::Failed);
    ASSERT_TRUE(row) << static_cast<int>(state);
    EXPECT_EQ(row->to, MotionRunState::Ended);
    EXPECT_EQ(row->action, MotionRunAction::EndError);
  }
}

TEST(MotionRunTable, isDoneOnlyByATagOrByTheReplyThatIsAllThereIs) {
  for (const auto& row : MotionRunTable::kRows) {
    if (row.action != MotionRunAction::EndDone) continue;
    EXPECT_TRUE(row.event == MotionRunEvent::TagComplete || row.event == MotionRunEvent::AcceptedLast);
  }
}

TEST(MotionRunTable, stopsOnACancelUntilItIsStoppingAlready) {
  for (const auto state : {MotionRunState::Sent, MotionRunState::Executing, MotionRunState::Confirming}) {
    EXPECT_EQ(link::findTransition<MotionRunTable>(state, MotionRunEvent::Cancel)->action,
              MotionRunAction::SendStop);
  }
  for (const auto state : {MotionRunState::Stopping, MotionRunState::Settling, MotionRunState::Ended}) {
    EXPECT_FALSE(link::findTransition<MotionRunTable>(state, MotionRunEvent::Cancel));
  }
}

}  // namespace
}  // namespace cobot_command::blocks
