// A robot that comes and goes, at any phase of the session: what the process holds stays flat, and the link
// comes back.
#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <random>
#include <set>

#include "chain.h"
#include "figure.h"
#include "process_counts.h"
#include "process_memory.h"
#include "thorough.h"

namespace cobot_command::runtime {
namespace {

using LinkState = command::CommandStatus::LinkState;

/// What a commander has told, as far as a cycle needs it: nothing is kept for ever.
class Watch {
 public:
  void see(const command::Action& action) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const auto* const changed = std::get_if<command::StatusChanged>(&action)) {
      link_ = changed->status.link;
    } else if (const auto* const accepted = std::get_if<command::GoalAccepted>(&action)) {
      under_way_.insert(accepted->goal);
    } else if (const auto* const ended = std::get_if<command::GoalEnded>(&action)) {
      under_way_.erase(ended->goal);
      ++ends_;
    }
    changed_.notify_all();
  }
  [[nodiscard]] bool linkReaches(LinkState state) {
    return waitUntil([&] { return link_ == state; });
  }
  [[nodiscard]] bool linkIsMade() {
    return waitUntil([&] { return link_ != LinkState::Disconnected && link_ != LinkState::Connecting; });
  }
  [[nodiscard]] bool ends(std::size_t goals) {
    return waitUntil([&] { return ends_ == goals && under_way_.empty(); });
  }

 private:
  template <class Condition>
  bool waitUntil(Condition condition) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, testing::kDeadline, condition);
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  LinkState link_ = LinkState::Disconnected;
  std::set<blocks::GoalId> under_way_;
  std::size_t ends_ = 0;
};

SimulatorPorts freePorts() {
  return Robot(1).ports();
}

/// A commander that keeps its link by itself, as the node does.
struct Keeper {
  Keeper(SimulatorPorts ports, link::LinkSettings settings)
      : runtime(testArm(), with(std::move(settings), ports.status),
                [this](const command::Action& action, Instant /*now*/) { watch.see(action); }) {
    runtime.keepConnected(blocks::ConnectGoal{"127.0.0.1", ports.script, 60, {}});
  }
  void submit(const blocks::Goal& goal) { EXPECT_TRUE(runtime.submit(++goals, goal)); }

  static link::LinkSettings with(link::LinkSettings settings, int status_port) {
    settings.status_port = status_port;
    return settings;
  }

  Watch watch;
  std::size_t goals = 0;
  CommandRuntime runtime;
};

/// The robot comes, and goes at some phase of what follows.
void comeAndGo(Keeper& keeper, SimulatorPorts ports, int phase) {
  Robot robot(20, ports);
  switch (phase) {
    case 0:
      return;
    case 1:
      EXPECT_TRUE(keeper.watch.linkIsMade());
      return;
    default:
      break;
  }
  EXPECT_TRUE(keeper.watch.linkReaches(LinkState::Ready));
  if (phase > 2) {
    keeper.submit(moveJoints({static_cast<double>(phase), 0, 90, 0, 90, 0}, 1));
  }
  if (phase > 3) {
    keeper.submit(blocks::StopGoal{});
  }
  if (phase > 4) {
    robot.operate([](auto& controller, Instant now) { controller.operate(simulator::StopProject{}, now); });
  }
}

/// Of many looks, over some tries to connect: each of these has its socket for a moment.
int fewestDescriptors() {
  int fewest = testing::openDescriptors();
  for (int i = 0; i < 2000; ++i) fewest = std::min(fewest, testing::openDescriptors());
  return fewest;
}

/// What a process has, which must not grow.
struct Held {
  int descriptors = fewestDescriptors();
  int threads = testing::runningThreads();
  std::size_t memory = testing::allocatedBytes().value_or(0);
};

TEST(Cycles, ofTheRobotAtAnyPhaseLeaveTheCommanderAsItWas) {
  constexpr std::size_t kMostGrowth = std::size_t{1024} * 1024;
  const auto ports = freePorts();
  link::LinkSettings settings;
  settings.retry_min = std::chrono::milliseconds(1);
  settings.retry_max = std::chrono::milliseconds(20);
  Keeper keeper(ports, settings);
  std::mt19937 random(20240611);
  std::uniform_int_distribution<int> any_phase(0, 5);
  const int cycles = testing::quickOrThorough(100, 1000);
  std::optional<Held> first;
  for (int i = 0; i < cycles; ++i) {
    comeAndGo(keeper, ports, any_phase(random));
    ASSERT_TRUE(keeper.watch.linkReaches(LinkState::Connecting)) << "cycle " << i;
    ASSERT_TRUE(keeper.watch.ends(keeper.goals)) << "a goal has no end in cycle " << i;
    if (i == cycles / 10) {
      first = Held();
    }
    ASSERT_FALSE(HasFailure()) << "cycle " << i;
  }
  const Held last;
  EXPECT_LE(last.descriptors, first->descriptors);
  EXPECT_LE(last.threads, first->threads);
  EXPECT_LE(last.memory, first->memory + kMostGrowth);
  testing::Figure descriptors("G5", "descriptors left by the last 90 % of the cycles", "", 0);
  descriptors.add(last.descriptors - first->descriptors);
  testing::Figure threads("G5", "threads left by them", "", 0);
  threads.add(last.threads - first->threads);
  testing::Figure memory("G5", "memory left by them", "KiB", 1024);
  memory.add((static_cast<double>(last.memory) - static_cast<double>(first->memory)) / 1024);
}

TEST(Cycles, bringTheLinkBackWhenTheRobotReturns) {
  testing::Figure figure("G5", "from the return of the robot until the link is Ready", "ms", 2000);
  const auto ports = freePorts();
  Keeper keeper(ports, link::LinkSettings{});
  for (int i = 0; i < testing::quickOrThorough(2, 50); ++i) {
    ASSERT_TRUE(keeper.watch.linkReaches(LinkState::Connecting));
    const Robot robot(1, ports);
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(keeper.watch.linkReaches(LinkState::Ready));
    figure.add(std::chrono::steady_clock::now() - start);
  }
}

}  // namespace
}  // namespace cobot_command::runtime
