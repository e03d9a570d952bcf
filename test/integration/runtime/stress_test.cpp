// Many threads at one command runtime while its robot comes and goes: every goal that was taken has one end.
//
// Made for the thread sanitizer (`scripts/test --sanitize thread`); without it, what is counted must hold all
// the same.
#include <atomic>
#include <map>
#include <mutex>
#include <random>
#include <thread>

#include "chain.h"

namespace cobot_command::runtime {
namespace {

constexpr int kGoalsOfEach = 250;
constexpr int kRestarts = 12;

/// Counts what becomes of the goals, on the core's thread and on all others.
class Ledger {
 public:
  void take(const command::Action& action) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto* const ended = std::get_if<command::GoalEnded>(&action)) ++ends_[ended->goal];
  }
  blocks::GoalId next() { return ++last_; }
  void taken() { ++taken_; }

  [[nodiscard]] int goals() const { return taken_; }
  [[nodiscard]] std::map<blocks::GoalId, int> ends() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return ends_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<blocks::GoalId, int> ends_;
  std::atomic<blocks::GoalId> last_{0};
  std::atomic<int> taken_{0};
};

blocks::Goal anyGoal(std::mt19937& random, int port) {
  switch (random() % 8) {
    case 0:
      return blocks::ConnectGoal{"127.0.0.1", port, 60, {}};
    case 1:
      return blocks::StopGoal{};
    case 2:
      return blocks::ProgramControlGoal{0, static_cast<int>(random() % 2)};
    case 3: {
      blocks::CheckSequenceGoal check;
      check.steps.assign(3, moveJoints({30, 0, 90, 0, 90, 0}));
      return check;
    }
    default: {
      auto move = moveJoints({static_cast<double>(random() % 40), 0, 90, 0, 90, 0});
      move.buffer_mode = static_cast<int>(random() % 3);
      move.blending_enable = random() % 4 == 0;
      return move;
    }
  }
}

/// What one client does: goals of all kinds, some of them cancelled at once, some of another client's.
void submitMany(CommandRuntime& runtime, Ledger& ledger, unsigned seed, int port) {
  std::mt19937 random(seed);
  for (int i = 0; i < kGoalsOfEach; ++i) {
    const auto id = ledger.next();
    if (runtime.submit(id, anyGoal(random, port))) ledger.taken();
    if (random() % 3 == 0) runtime.cancel(id - random() % 3);
    std::this_thread::yield();
  }
}

/// The power of the robot goes off and on; an operator is at the pendant meanwhile.
void restartMany(SimulatorPorts ports) {
  for (int i = 0; i < kRestarts; ++i) {
    Robot robot(kFastestTimeScale, ports);
    robot.operate([](auto& controller, Instant now) { controller.operate(simulator::StopProject{}, now); });
    robot.operate([](auto& controller, Instant now) { controller.operate(simulator::RunProject{}, now); });
    (void)robot.state();
  }
}

SimulatorPorts freePorts() {
  return Robot(1).ports();
}

TEST(Stress, ofManyThreadsGivesEachGoalItsOneEnd) {
  const SimulatorPorts ports = freePorts();
  Ledger ledger;
  link::LinkSettings settings;
  settings.status_port = ports.status;
  CommandRuntime runtime(testArm(), settings,
                         [&](const command::Action& action, Instant /*now*/) { ledger.take(action); });
  runtime.keepConnected(blocks::ConnectGoal{"127.0.0.1", ports.script, 60, {}});
  std::vector<std::thread> threads;
  threads.emplace_back(restartMany, ports);
  for (unsigned seed = 1; seed <= 4; ++seed) {
    threads.emplace_back([&, seed] { submitMany(runtime, ledger, seed, ports.script); });
  }
  for (auto& thread : threads) {
    thread.join();
  }
  runtime.stop();
  const auto ends = ledger.ends();
  EXPECT_EQ(ledger.goals(), 4 * kGoalsOfEach);
  EXPECT_EQ(ends.size(), static_cast<std::size_t>(ledger.goals()));
  for (const auto& [goal, count] : ends) {
    EXPECT_EQ(count, 1) << "goal " << goal;
  }
}

TEST(Stress, ofStopsInTheMidstOfGoalsEndsWhatWasTaken) {
  Robot robot(kFastestTimeScale);
  for (unsigned round = 0; round < 10; ++round) {
    Ledger ledger;
    link::LinkSettings settings;
    settings.status_port = robot.ports().status;
    CommandRuntime runtime(testArm(), settings,
                           [&](const command::Action& action, Instant /*now*/) { ledger.take(action); });
    std::vector<std::thread> threads;
    for (unsigned seed = 0; seed < 3; ++seed) {
      threads.emplace_back(
          [&, seed] { submitMany(runtime, ledger, 100 * round + seed, robot.ports().script); });
    }
    threads.emplace_back([&] { runtime.stop(); });
    for (auto& thread : threads) {
      thread.join();
    }
    EXPECT_EQ(ledger.ends().size(), static_cast<std::size_t>(ledger.goals()));
  }
}

}  // namespace
}  // namespace cobot_command::runtime
