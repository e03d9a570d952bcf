// The tables of the two kinds of goals.

#include "connecting/connect_run_states.h"
#include "exchange/exchange_states.h"
#include "paths/load_path_states.h"
#include "runs/command_run_states.h"
#include "runs/pick_and_place_states.h"
#include "stops/stop_run_states.h"
#include "sync/sync_guard_states.h"
#include "table_checks.h"
#include <gtest/gtest.h>

#include "cobot_command/robot/orphan_states.h"

namespace cobot_command::command {
namespace {

using namespace blocks;
using namespace robot;

using testing::allUpTo;
using testing::expectSoundTable;

TEST(CommandRunTable, isSound) {
  expectSoundTable<CommandRunTable>(CommandRunState::Ended, CommandRunEvent::Stopped, CommandRunState::Sent,
                                    {CommandRunState::Ended});
}

TEST(ExchangeTable, isSound) {
  expectSoundTable<ExchangeTable>(ExchangeState::Disabling, ExchangeEvent::ShutDown, ExchangeState::Disabled);
}

TEST(SyncGuardTable, isSound) {
  expectSoundTable<SyncGuardTable>(SyncGuardState::Resumable, SyncGuardEvent::LinkLost, SyncGuardState::Free);
}

/// Nothing resumes by itself.
TEST(SyncGuardTable, leavesAnInterruptionOnlyByItsClientOrWhereNothingIsLeft) {
  for (const auto& row : SyncGuardTable::kRows) {
    const bool was_held = row.from == SyncGuardState::Interrupted || row.from == SyncGuardState::Resumable;
    if (was_held && row.to == SyncGuardState::Free) {
      EXPECT_TRUE(row.event == SyncGuardEvent::Resumed || row.event == SyncGuardEvent::Emptied ||
                  row.event == SyncGuardEvent::LinkLost);
    }
  }
}

TEST(OrphanTable, isSound) {
  expectSoundTable<OrphanTable>(OrphanState::Unseen, OrphanEvent::LinkGone, OrphanState::NoLink);
}

TEST(OrphanTable, findsOneOnlyOnceForEachLink) {
  for (const auto& row : OrphanTable::kRows) {
    if (row.action == OrphanAction::Found) {
      EXPECT_EQ(row.from, OrphanState::Looking);
    }
    if (row.to == OrphanState::Looking) {
      EXPECT_EQ(row.from, OrphanState::NoLink);
    }
  }
}

TEST(OrphanTable, endsAMotionOnlyWhenTheRobotIsSeenToStandOrStopped) {
  for (const auto& row : OrphanTable::kRows) {
    const bool moved = row.from == OrphanState::Moving || row.from == OrphanState::Unseen;
    if (moved && row.to == OrphanState::None) {
      EXPECT_TRUE(row.event == OrphanEvent::SeenStanding || row.event == OrphanEvent::Stopped);
    }
  }
}

TEST(StopTable, isSound) {
  expectSoundTable<StopTable>(StopState::Ended, StopEvent::GiveUp, StopState::Asked, {StopState::Ended});
}

TEST(StopTable, endsWithALaterOneAndByItsTimeInEveryState) {
  for (const auto state : allUpTo(StopState::Failing)) {
    const auto stands = findTransition<StopTable>(state, StopEvent::Standing);
    ASSERT_TRUE(stands) << static_cast<int>(state);
    EXPECT_EQ(stands->action, StopAction::EndStopped);
    const auto over = findTransition<StopTable>(state, StopEvent::GiveUp);
    ASSERT_TRUE(over) << static_cast<int>(state);
    EXPECT_EQ(over->action, StopAction::EndFailed);
  }
}

TEST(PickAndPlaceTable, isSound) {
  expectSoundTable<PickAndPlaceTable>(PickAndPlaceState::Ended, PickAndPlaceEvent::Cancelled,
                                      PickAndPlaceState::Moving, {PickAndPlaceState::Ended});
}

TEST(PickAndPlaceTable, canFailAndBeCancelledInEveryState) {
  for (const auto state : allUpTo(PickAndPlaceState::Explaining)) {
    for (const auto event : {PickAndPlaceEvent::Failed, PickAndPlaceEvent::Cancelled}) {
      const auto row = findTransition<PickAndPlaceTable>(state, event);
      ASSERT_TRUE(row) << static_cast<int>(state);
      EXPECT_EQ(row->to, PickAndPlaceState::Ended);
    }
  }
}

TEST(LoadPathTable, isSound) {
  expectSoundTable<LoadPathTable>(LoadPathState::Ended, LoadPathEvent::NothingLeft, LoadPathState::Following,
                                  {LoadPathState::Ended});
}

TEST(LoadPathTable, endsAsFailedOnlyBehindAFailure) {
  for (const auto& row : LoadPathTable::kRows) {
    const bool failed = row.from == LoadPathState::Failing || row.from == LoadPathState::Explaining;
    EXPECT_EQ(row.to == LoadPathState::Ended && failed, row.action == LoadPathAction::EndFailed);
  }
}

TEST(ConnectTable, isSound) {
  expectSoundTable<ConnectTable>(ConnectState::Disconnecting, ConnectEvent::MotionsEnded, ConnectState::Idle);
}

TEST(CommandRunTable, endsOnAFailureInEveryState) {
  for (const auto state : allUpTo(CommandRunState::Stopping)) {
    const auto row = findTransition<CommandRunTable>(state, CommandRunEvent::Failed);
    ASSERT_TRUE(row) << static_cast<int>(state);
    EXPECT_EQ(row->to, CommandRunState::Ended);
    EXPECT_EQ(row->action, CommandRunAction::EndError);
  }
}

TEST(CommandRunTable, isDoneOnlyBehindATagThatWasVerifiedOrByTheReplyThatIsAllThereIs) {
  for (const auto& row : CommandRunTable::kRows) {
    if (row.action == CommandRunAction::EndDone) {
      EXPECT_TRUE(row.event == CommandRunEvent::Verified || row.event == CommandRunEvent::AcceptedLast);
    }
    if (row.event == CommandRunEvent::TagComplete && row.from != CommandRunState::Sent) {
      EXPECT_EQ(row.to, CommandRunState::Verifying);
    }
  }
}

TEST(CommandRunTable, waitsForTheReasonOfAFailureWheneverThatMayCome) {
  for (const auto state : allUpTo(CommandRunState::Stopping)) {
    const auto row = findTransition<CommandRunTable>(state, CommandRunEvent::Unexplained);
    EXPECT_EQ(row.has_value(), state != CommandRunState::Explaining);
    if (row) {
      EXPECT_EQ(row->to, CommandRunState::Explaining);
    }
  }
}

TEST(CommandRunTable, stopsOnACancelUntilItIsStoppingAlready) {
  for (const auto state : {CommandRunState::Sent, CommandRunState::Executing, CommandRunState::Confirming,
                           CommandRunState::Verifying}) {
    EXPECT_EQ(findTransition<CommandRunTable>(state, CommandRunEvent::Cancel)->action,
              CommandRunAction::AskForStop);
  }
  for (const auto state : {CommandRunState::Explaining, CommandRunState::Stopping, CommandRunState::Ended}) {
    EXPECT_FALSE(findTransition<CommandRunTable>(state, CommandRunEvent::Cancel));
  }
}

}  // namespace
}  // namespace cobot_command::command
