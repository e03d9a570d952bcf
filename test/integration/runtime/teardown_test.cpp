// A commander can be ended in every state of its session, at once, and each of its goals has its one end.
#include <algorithm>
#include <future>
#include <string>
#include <thread>

#include "figure.h"
#include "session_states.h"
#include "thorough.h"
#include "watched.h"

namespace cobot_command::runtime {
namespace {

/// Far above the 500 ms that it may take, and far below the minutes that a wait for the network would.
constexpr auto kQuickEnough = std::chrono::seconds(10);
constexpr double kLimitMs = 500;

// What takes two seconds takes a hundred under a sanitizer: time for a heap of status frames.
constexpr int kLines = testing::kIsWatched ? 1 : 20;
constexpr double kLength = testing::kIsWatched ? 100 : 300;  // [mm]

/// Far more than kRetirement to plan, on the core's thread, and no motion.
blocks::CheckSequenceGoal longPlanning() {
  blocks::CheckSequenceGoal check;
  for (int i = 0; i < kLines; ++i) {
    check.steps.emplace_back(moveLine(kStartJoints, {0, 0, i % 2 == 0 ? -kLength : 0.0}, 1));
  }
  check.start_joints.assign(kStartJoints.begin(), kStartJoints.end());
  return check;
}

double speedOf(Session& session) {
  return session.robot->state().velocities.cwiseAbs().maxCoeff();
}

class Teardown : public ::testing::TestWithParam<SessionState> {};
INSTANTIATE_TEST_SUITE_P(Session, Teardown, ::testing::ValuesIn(sessionStates()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(Teardown, isQuickAndEndsEachGoal) {
  testing::Figure figure("G7", std::string("teardown, ") + GetParam().name, "ms", kLimitMs);
  for (int i = 0; i < testing::quickOrThorough(1, 100); ++i) {
    Session session;
    GetParam().reach(session);
    ASSERT_FALSE(HasFailure()) << "the state is not reached";
    const auto stopping = testing::timeOf([&] { session.commander->stop(); });
    EXPECT_EQ(session.commander->told<command::GoalEnded>().size(), session.commander->submitted());
    const auto destroying = testing::timeOf([&] { session.commander.reset(); });
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
    EXPECT_GE(testing::timeOf([&] { session.commander->stop(); }), kRetirement);
    again = std::min(again, testing::timeOf([&] {
                       session.commander->stop();
                       session.commander.reset();
                     }));
  }
  EXPECT_LT(again, kRetirement);
}

TEST(Stop, givesTheRobotItsTimeAndDropsWhatIsPlanned) {
  Session session;
  session.beReady();
  const auto move = session.move();
  const auto check = session.commander->submit(longPlanning());
  session.commander->stop();
  const auto checked = session.commander->outcomeOf(check);
  ASSERT_TRUE(checked && checked->ending == blocks::Ending::CommandAborted) << checked->error_description;
  const auto outcome = session.commander->outcomeOf(move);
  ASSERT_TRUE(outcome.has_value());
  EXPECT_EQ(outcome->error_description.find("may still move"), std::string::npos)
      << outcome->error_description;
  EXPECT_LT(speedOf(session), degToRad(0.1));
}

TEST(Stop, ofTheRobotIsOutWhenTheEndIsToldToHaveBegunWhateverIsPlanned) {
  Session session;
  session.beReady();
  const auto move = session.move();
  (void)session.commander->submit(longPlanning());
  std::promise<void> begun;
  session.commander->runtime().retire([&] { begun.set_value(); });
  begun.get_future().get();
  EXPECT_TRUE(session.commander->outcomeOf(move).has_value());
  EXPECT_LT(speedOf(session), degToRad(0.1));
  session.commander->stop();
  bool is_called = false;
  session.commander->runtime().retire([&] { is_called = true; });
  EXPECT_TRUE(is_called);
}

TEST(Finish, isAnsweredBesideAPlanningAndNotAtAllOnceAllHasEnded) {
  Session session;
  session.beReady();
  const auto move = session.move();
  const auto check = session.commander->submit(longPlanning());
  auto report = session.commander->runtime().finish(blocks::FinishAfter::Move);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->get().under_way, blocks::kBlock<blocks::MoveAbsoluteGoal>);
  const auto ended = session.commander->told<command::GoalEnded>();
  EXPECT_TRUE(std::none_of(ended.begin(), ended.end(), [&](const auto& goal) { return goal.goal == check; }));
  session.commander->cancel(move);
  session.commander->stop();
  EXPECT_FALSE(session.commander->runtime().finish(blocks::FinishAfter::Move).has_value());
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
