// What must hold however often and whenever a runtime begins and ends.
#include <thread>

#include "chain.h"
#include "process_counts.h"

namespace cobot_command::runtime {
namespace {

TEST(Submit, fromManyThreadsGivesEachGoalItsOneEnd) {
  Robot robot(kFastestTimeScale);
  testing::EventLog<blocks::GoalId> ends;
  link::LinkSettings settings;
  settings.status_port = 0;
  CommandRuntime runtime(testArm(), settings, [&](const command::Action& action, Instant /*now*/) {
    if (const auto* const ended = std::get_if<command::GoalEnded>(&action)) {
      ends.add(ended->goal);
    }
  });
  constexpr blocks::GoalId kEach = 50;
  std::vector<std::thread> threads;
  for (blocks::GoalId first = 0; first < 4; ++first) {
    threads.emplace_back([&, first] {
      for (blocks::GoalId i = 0; i < kEach; ++i) {
        const auto id = first * kEach + i + 1;
        EXPECT_TRUE(runtime.submit(id, blocks::ConnectGoal{"127.0.0.1", robot.ports().script, 60, {}}));
        runtime.cancel(id);
      }
    });
  }
  for (auto& thread : threads) {
    thread.join();
  }
  runtime.stop();
  auto goals = ends.events();
  std::sort(goals.begin(), goals.end());
  EXPECT_EQ(goals.size(), 4 * kEach);
  EXPECT_EQ(std::unique(goals.begin(), goals.end()), goals.end());
}

TEST(Cycles, leaveNoThreadAndNoDescriptorBehind) {
  const auto cycle = [] {
    Robot robot(20);
    Commander commander(robot.ports().status);
    (void)commander.connect(robot.ports());
  };
  cycle();
  const int descriptors = testing::openDescriptors();
  const int threads = testing::runningThreads();
  for (int i = 0; i < 100; ++i) {
    cycle();
  }
  EXPECT_EQ(testing::openDescriptors(), descriptors);
  EXPECT_EQ(testing::runningThreads(), threads);
}

}  // namespace
}  // namespace cobot_command::runtime
