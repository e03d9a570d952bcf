// A commander can be ended in every state of its session, at once, and each of its goals has its one end.
#include <algorithm>
#include <thread>

#include "figure.h"
#include "session_states.h"
#include "thorough.h"

namespace cobot_command::runtime {
namespace {

/// Far above the 500 ms that it may take, and far below the minutes that a wait for the network would.
constexpr auto kQuickEnough = std::chrono::seconds(10);
constexpr double kLimitMs = 500;

class Teardown : public testing::TestWithParam<SessionState> {};
INSTANTIATE_TEST_SUITE_P(Session, Teardown, testing::ValuesIn(sessionStates()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(Teardown, isQuickAndEndsEachGoal) {
  test::Figure figure("G7", std::string("teardown, ") + GetParam().name, "ms", kLimitMs);
  for (int i = 0; i < test::quickOrThorough(1, 100); ++i) {
    Session session;
    GetParam().reach(session);
    ASSERT_FALSE(HasFailure()) << "the state is not reached";
    const auto stopping = test::timeOf([&] { session.commander->stop(); });
    EXPECT_EQ(session.commander->told<blocks::GoalEnded>().size(), session.commander->submitted());
    const auto destroying = test::timeOf([&] { session.commander.reset(); });
    ASSERT_LT(stopping + destroying, kQuickEnough);
    figure.add(stopping + destroying);
  }
}

TEST(Stop, waitsOnceForARobotThatDoesNotConfirmItHoweverOftenItIsAskedFor) {
  auto again = std::chrono::steady_clock::duration::max();
  for (int i = 0; i < 3; ++i) {  // the best of these, as the machine may be busy
    Session session;
    session.beReady();
    session.move();
    session.fault("silence");
    EXPECT_GE(test::timeOf([&] { session.commander->stop(); }), kRetirement);
    again = std::min(again, test::timeOf([&] {
                       session.commander->stop();
                       session.commander.reset();
                     }));
  }
  EXPECT_LT(again, kRetirement);
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

}  // namespace
}  // namespace cobot_command::runtime
