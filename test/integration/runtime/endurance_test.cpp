// What must hold however often and whenever a runtime begins and ends.
#include <thread>

#include "chain.h"
#include "process_counts.h"
#include <boost/asio/ip/tcp.hpp>

namespace cobot_command::runtime {
namespace {

using blocks::Phase;
using boost::asio::ip::tcp;

/// Far above the 500 ms that a stop may take, and far below the minutes that a wait for the network would.
constexpr auto kQuickEnough = std::chrono::seconds(10);

/// No try ends by itself while a test looks at it.
link::LinkSettings patient() {
  link::LinkSettings settings;
  settings.open_timeout = std::chrono::minutes(10);
  settings.reply_timeout = std::chrono::minutes(10);
  return settings;
}

void expectQuickStop(Commander& commander) {
  const auto start = std::chrono::steady_clock::now();
  commander.stop();
  EXPECT_LT(std::chrono::steady_clock::now() - start, kQuickEnough);
  const auto accepted = commander.told<blocks::GoalAccepted>().size();
  EXPECT_EQ(commander.told<blocks::GoalEnded>().size(), accepted) << "every goal has one end";
}

TEST(Stop, isQuickWithNothingToDo) {
  Commander commander(0);
  expectQuickStop(commander);
}

TEST(Stop, isQuickWhileNobodyAnswersTheTry) {
  boost::asio::io_context context;
  tcp::acceptor full(context, {tcp::v4(), 0}, false);
  full.listen(0);
  const tcp::endpoint address(boost::asio::ip::address_v4::loopback(), full.local_endpoint().port());
  tcp::socket filler(context);
  filler.connect(address);
  Commander commander(0, patient());
  const auto goal = commander.submit(blocks::ConnectGoal{"127.0.0.1", address.port(), 300, {}});
  ASSERT_TRUE(commander.reaches(goal, Phase::Connecting));
  expectQuickStop(commander);
}

TEST(Stop, isQuickWhileANameIsLookedUp) {
  Commander commander(0, patient());
  commander.submit(blocks::ConnectGoal{"no-such-robot.invalid", 5890, 300, {}});
  expectQuickStop(commander);
}

TEST(Stop, isQuickWhileTheOtherSideIsSilent) {
  boost::asio::io_context context;
  tcp::acceptor silent(context, {tcp::v4(), 0}, false);
  Commander commander(0, patient());
  const auto goal = commander.submit(
      blocks::ConnectGoal{"127.0.0.1", static_cast<int>(silent.local_endpoint().port()), 300, {}});
  ASSERT_TRUE(commander.reaches(goal, Phase::Probing));
  expectQuickStop(commander);
}

TEST(Stop, isQuickInMotionAndWithTheRobotGone) {
  Robot robot(1);
  Commander moving(robot.ports().status, patient());
  (void)moving.connect(robot.ports());
  const auto move = moving.submit(endlessMove());
  ASSERT_TRUE(moving.reaches(move, Phase::Active));
  expectQuickStop(moving);

  Commander bereft(robot.ports().status, patient());
  (void)bereft.connect(robot.ports());
  robot.powerOff();
  expectQuickStop(bereft);
}

TEST(Stop, mayBeAskedForByManyAtOnce) {
  Robot robot(20);
  Commander commander(robot.ports().status);
  (void)commander.connect(robot.ports());
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      commander.stop();
      EXPECT_FALSE(commander.runtime().submit(1000, endlessMove())) << "stopped for each who asked";
    });
  }
  for (auto& thread : threads) {
    thread.join();
  }
}

TEST(Submit, fromManyThreadsGivesEachGoalItsOneEnd) {
  Robot robot(kFastestTimeScale);
  test::EventLog<blocks::GoalId> ends;
  link::LinkSettings settings;
  settings.status_port = 0;
  CommandRuntime runtime(testArm(), settings, [&](const blocks::Action& action, Instant /*now*/) {
    if (const auto* const ended = std::get_if<blocks::GoalEnded>(&action)) {
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
  const int descriptors = test::openDescriptors();
  const int threads = test::runningThreads();
  for (int i = 0; i < 100; ++i) {
    cycle();
  }
  EXPECT_EQ(test::openDescriptors(), descriptors);
  EXPECT_EQ(test::runningThreads(), threads);
}

TEST(Cycles, ofTheRobotLeaveTheCommanderAsItWas) {
  SimulatorPorts ports;
  {
    const Robot robot(20);
    ports = robot.ports();
  }
  Commander commander(ports.status);
  const auto cycle = [&] {
    Robot robot(20, ports);
    const auto link = commander.connect(ports);
    robot.powerOff();
    EXPECT_TRUE(commander.outcomeOf(link).has_value());
  };
  cycle();
  const int descriptors = test::openDescriptors();
  const int threads = test::runningThreads();
  for (int i = 0; i < 25; ++i) {
    cycle();
  }
  EXPECT_EQ(test::openDescriptors(), descriptors);
  EXPECT_EQ(test::runningThreads(), threads);
}

}  // namespace
}  // namespace cobot_command::runtime
