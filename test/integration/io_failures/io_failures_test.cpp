// Each single system call of a session fails, one in each run: every goal has its one end, nothing hangs, and
// the next connect works.
#include <cerrno>
#include <cstring>

#include "chain.h"
#include "failing_call.h"
#include "figure.h"
#include "network.h"

namespace cobot_command::runtime {
namespace {

constexpr double kQuick = 50;  ///< times real time
/// Far above what a stop may take, far below a wait for the network.
constexpr auto kQuickEnough = std::chrono::seconds(10);

simulator::Settings sparseStream() {
  simulator::Settings settings;
  settings.status_period = std::chrono::milliseconds(500);  // 10 ms of real time
  return settings;
}

link::LinkSettings eager() {
  link::LinkSettings settings;
  settings.retry_min = std::chrono::milliseconds(1);
  settings.retry_max = std::chrono::milliseconds(20);
  settings.reply_timeout = std::chrono::milliseconds(500);
  return settings;
}

/// A robot that was switched on before anything fails, and a commander for it.
struct Session {
  Robot robot{kQuick, {}, sparseStream()};
  Commander commander{robot.ports().status, eager()};

  /// Whatever becomes of it, it ends.
  void end(const blocks::Goal& goal) { EXPECT_TRUE(commander.run(goal).has_value()); }
  blocks::GoalId beginConnecting() {
    return commander.submit(blocks::ConnectGoal{"127.0.0.1", robot.ports().script, 60, {}});
  }

  /// A connect, a move, a script, a cancelled move, a disconnect.
  void tell() {
    const auto link = beginConnecting();
    EXPECT_TRUE(commander.waitFor<command::StatusChanged>(
        [](const auto& changed) { return changed.status.link == command::CommandStatus::LinkState::Ready; }));
    end(moveJoints({1, 0, 90, 0, 90, 0}));
    end(blocks::RunScriptGoal{"ChangeBase(\"RobotBase\")", false, 0, 0});
    const auto cancelled = commander.submit(endlessMove());
    commander.cancel(cancelled);
    EXPECT_TRUE(commander.outcomeOf(cancelled).has_value());
    commander.cancel(link);
    EXPECT_TRUE(commander.outcomeOf(link).has_value());
  }

  /// Now that nothing fails any more.
  void works() {
    const auto link = beginConnecting();
    EXPECT_TRUE(commander.reaches(link, blocks::Phase::Connected));
    const auto outcome = commander.run(moveJoints({2, 0, 90, 0, 90, 0}));
    ASSERT_TRUE(outcome.has_value());
    EXPECT_EQ(outcome->ending, blocks::Ending::Done) << outcome->error_description;
  }
};

class IoFailure : public ::testing::TestWithParam<Failure> {};
INSTANTIATE_TEST_SUITE_P(Of, IoFailure,
                         ::testing::Values(Failure{"socket", Call::Socket, EMFILE},
                                           Failure{"connect", Call::Connect, ENETUNREACH},
                                           Failure{"connect_without_a_port", Call::Connect, EADDRNOTAVAIL},
                                           Failure{"accept", Call::Accept, EMFILE},
                                           Failure{"accept_of_who_went", Call::Accept, ECONNABORTED},
                                           Failure{"send", Call::Send, ECONNRESET},
                                           Failure{"send_without_memory", Call::Send, ENOBUFS},
                                           Failure{"receive", Call::Receive, ECONNRESET},
                                           Failure{"receive_without_memory", Call::Receive, ENOMEM},
                                           Failure{"poll", Call::Poll, ENOMEM},
                                           Failure{"epoll_ctl", Call::EpollControl, ENOMEM},
                                           Failure{"setsockopt", Call::SetOption, ENOBUFS}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// True when the n-th call of the session failed; false when it has not as many.
bool survives(const Failure& failure, int n) {
  Session session;
  bool happened = false;
  {
    const FailingCall failing(failure, n);
    session.tell();
    happened = failing.happened();
  }
  session.works();
  EXPECT_LT(testing::timeOf([&] { session.commander.stop(); }), kQuickEnough);
  EXPECT_EQ(session.commander.told<command::GoalEnded>().size(), session.commander.submitted());
  return happened;
}

TEST_P(IoFailure, atAnyCallEndsEachGoalAndTheNextConnectWorks) {
  constexpr int kMost = 500;  // far more than a session has
  int n = 1;
  while (n <= kMost && survives(GetParam(), n)) {
    ASSERT_FALSE(HasFailure()) << "call " << n;
    ++n;
  }
  EXPECT_LE(n, kMost);
  EXPECT_GT(n, 1) << "it was never called, so it could not fail";
  RecordProperty("failed_calls", n - 1);
}

/// What was not sent will not be answered: nobody has to wait for a deadline to learn that.
TEST(FailedSend, endsTheConnectionAndSaysWhy) {
  boost::asio::io_context context;
  transport::Server server(context);
  transport::Client client(context);
  client.open(server.port);
  ASSERT_TRUE(transport::runUntil(context, [&] { return client.opened == 1 && server.clients.size() == 1; }));
  {
    const FailingCall failing({"send_without_memory", Call::Send, ENOBUFS}, 1);
    client.connection.send("lost");
    ASSERT_TRUE(failing.happened());
  }
  ASSERT_TRUE(transport::runUntil(context, [&] { return client.closed.has_value(); }));
  EXPECT_EQ(*client.closed, std::strerror(ENOBUFS));
  EXPECT_TRUE(transport::runUntil(context, [&] { return server.disconnected.size() == 1; }));
}

}  // namespace
}  // namespace cobot_command::runtime
