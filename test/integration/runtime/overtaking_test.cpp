// What stops the robot overtakes what waits for the core's thread, and takes with it what was received before
// it. The thread is held still here, so that the order is the test's.
#include <atomic>
#include <future>
#include <thread>

#include "chain.h"
#include "script_peer.h"

namespace cobot_command::runtime {
namespace {

class Overtaking : public ::testing::Test {
 protected:
  Overtaking() { static_cast<void>(commander.connect(peer.ports())); }
  ~Overtaking() override { letGo(); }

  /// Until letGo(); returns when it stands still.
  void holdCore() {
    std::promise<void> held;
    commander.runtime().inCore([&held, go = going_.get_future().share()](Instant) {
      held.set_value();
      go.wait();
    });
    held.get_future().wait();
    is_held_ = true;
  }
  void letGo() {
    if (std::exchange(is_held_, false)) going_.set_value();
  }
  void expectRecalled(blocks::GoalId goal) {
    const auto outcome = commander.outcomeOf(goal);
    ASSERT_TRUE(outcome.has_value());
    EXPECT_EQ(outcome->ending, blocks::Ending::CommandAborted) << outcome->error_description;
  }
  static blocks::SetOutputGoal outputAtOnce() {
    blocks::SetOutputGoal output;
    output.module = "ControlBox";
    output.value = 1;
    output.at_once = true;
    return output;
  }

  ScriptPeer peer;
  Commander commander{peer.ports().status};

 private:
  std::promise<void> going_;
  bool is_held_ = false;
};

TEST_F(Overtaking, aStopEndsWhatWasReceivedBeforeItAndNothingOfThatIsSent) {
  holdCore();
  const auto move = commander.submit(moveJoints({10, 0, 90, 0, 90, 0}));
  const auto output = commander.submit(outputAtOnce());
  const auto stop = commander.submit(blocks::StopGoal{});
  letGo();
  expectRecalled(move);
  expectRecalled(output);
  EXPECT_TRUE(commander.outcomeOf(stop).has_value());
  EXPECT_TRUE(peer.hasHeard(kStop));
  EXPECT_FALSE(peer.hasHeard("PTP"));
  EXPECT_FALSE(peer.hasHeard("IO["));
}

TEST_F(Overtaking, aStopLeavesWhatIsReceivedAfterIt) {
  holdCore();
  const auto stop = commander.submit(blocks::StopGoal{});
  const auto output = commander.submit(outputAtOnce());
  letGo();
  EXPECT_TRUE(commander.outcomeOf(stop).has_value());
  const auto outcome = commander.outcomeOf(output);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, blocks::Ending::Done) << outcome->error_description;
}

TEST_F(Overtaking, aCancelEndsAGoalThatTheCoreHasNotSeenYet) {
  holdCore();
  const auto move = commander.submit(moveJoints({10, 0, 90, 0, 90, 0}));
  commander.cancel(move);
  letGo();
  expectRecalled(move);
  EXPECT_FALSE(peer.hasHeard("PTP"));
}

TEST_F(Overtaking, aCancelOfWhatIsUnderWayTakesWhatWasReceivedBeforeIt) {
  const auto move = commander.submit(moveJoints({10, 0, 90, 0, 90, 0}));
  ASSERT_TRUE(peer.timeOf("PTP", 0).has_value());
  holdCore();
  auto next = moveJoints({20, 0, 90, 0, 90, 0});
  next.buffer_mode = static_cast<int>(blocks::BufferMode::Buffered);
  const auto behind = commander.submit(next);
  commander.runtime().cancel(move, behind);
  letGo();
  expectRecalled(behind);
  expectRecalled(move);
  EXPECT_TRUE(peer.hasHeard(kStop));
}

TEST_F(Overtaking, keepAlivesWithoutEndKeepNoGoalWaiting) {
  std::atomic<bool> is_over{false};
  std::thread flood([&] {
    while (!is_over) commander.runtime().keepJogging();
  });
  const auto outcome = commander.run(outputAtOnce());
  is_over = true;
  flood.join();
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->ending, blocks::Ending::Done) << outcome->error_description;
}

TEST_F(Overtaking, aPauseDoesNotWaitForGoals) {
  holdCore();
  const auto output = commander.submit(outputAtOnce());
  blocks::ProgramControlGoal pause;
  pause.command = static_cast<int>(blocks::ProgramCommand::Pause);
  const auto paused = commander.submit(pause);
  letGo();
  EXPECT_TRUE(commander.outcomeOf(paused).has_value());
  EXPECT_TRUE(commander.outcomeOf(output).has_value());
  const auto pause_at = peer.timeOf("Pause", 0);
  const auto output_at = peer.timeOf("IO[", 0);
  ASSERT_TRUE(pause_at && output_at);
  EXPECT_LE(*pause_at, *output_at);
}

}  // namespace
}  // namespace cobot_command::runtime
