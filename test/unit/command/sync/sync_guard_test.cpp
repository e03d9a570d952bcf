// What becomes of motions while data are out of sync, event by event.
#include "sync/sync_guard.h"

#include <chrono>

#include <gtest/gtest.h>

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;
using blocks::SyncReaction;

class SyncGuardTest : public ::testing::Test {
 protected:
  void begin(SyncReaction reaction, Duration delay = Duration::zero()) {
    guard.begin(delay, reaction);
    guard.look(seen, now);
  }
  void outOfSync() { see(false); }
  void inSync() { see(true); }
  void see(bool in_sync) {
    seen.in_sync = in_sync;
    guard.look(seen, now);
  }

  Instant now{1000s};
  SyncGuard guard;
  SyncGuard::Seen seen{true, true, true, true, true};
};

TEST_F(SyncGuardTest, pausesWhatGoesOnWhenItInterrupts) {
  begin(SyncReaction::InterruptAtOnce);
  outOfSync();
  EXPECT_TRUE(guard.deniesResume());
  EXPECT_TRUE(guard.takePause());
  EXPECT_FALSE(guard.takePause()) << "once";
}

TEST_F(SyncGuardTest, pausesARobotAgainThatSomebodyHasLetGoMeanwhile) {
  begin(SyncReaction::InterruptAtOnce);
  outOfSync();
  EXPECT_TRUE(guard.takePause());
  inSync();
  outOfSync();
  EXPECT_TRUE(guard.takePause()) << "it may go on, as the pendant has let it";
}

TEST_F(SyncGuardTest, needsNoPauseWhereNothingMoves) {
  begin(SyncReaction::InterruptAtOnce);
  seen.moves = false;
  outOfSync();
  EXPECT_TRUE(guard.deniesResume());
  EXPECT_FALSE(guard.takePause());
}

TEST_F(SyncGuardTest, takesBackAResumeThatCameTooLate) {
  begin(SyncReaction::InterruptAtOnce);
  outOfSync();
  inSync();
  outOfSync();  // with the answer to Resume() still on its way
  static_cast<void>(guard.takePause());
  guard.resumed();
  EXPECT_TRUE(guard.deniesResume());
  EXPECT_TRUE(guard.takePause());
}

TEST_F(SyncGuardTest, waitsForTheDelayAlsoOfOneThatMayBeResumed) {
  begin(SyncReaction::InterruptAtOnce, 500ms);
  outOfSync();
  now += 500ms;
  outOfSync();
  ASSERT_TRUE(guard.deniesResume());
  inSync();
  outOfSync();
  EXPECT_FALSE(guard.deniesResume());
  now += 500ms;
  outOfSync();
  EXPECT_TRUE(guard.deniesResume());
}

TEST_F(SyncGuardTest, leavesResumeToItsClientWithoutAReaction) {
  begin(SyncReaction::InterruptAtOnce);
  outOfSync();
  guard.change(Duration::zero(), SyncReaction::None);
  outOfSync();
  EXPECT_FALSE(guard.deniesResume());
  EXPECT_TRUE(guard.interrupts()) << "nothing resumes by itself";
}

TEST_F(SyncGuardTest, takesAnotherDelayForTheClockThatRuns) {
  begin(SyncReaction::InterruptAtOnce, 10s);
  outOfSync();
  now += 1s;
  guard.change(500ms, SyncReaction::InterruptAtOnce);
  outOfSync();
  EXPECT_TRUE(guard.deniesResume());
}

TEST_F(SyncGuardTest, knowsNothingBeforeTheDataWereCompared) {
  seen.judged = false;
  begin(SyncReaction::NoEnable);
  outOfSync();
  EXPECT_FALSE(guard.refuses());
  seen.judged = true;
  outOfSync();
  EXPECT_TRUE(guard.refuses()) << "it was never seen in sync";
}

}  // namespace
}  // namespace cobot_command::command
