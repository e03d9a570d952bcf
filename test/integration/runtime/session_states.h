// Every state that the session of a commander can be in, and how to bring one there.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "chain.h"
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

namespace cobot_command::runtime {

/// No try ends by itself while a test looks at it.
inline link::LinkSettings patient() {
  link::LinkSettings settings;
  settings.open_timeout = std::chrono::minutes(10);
  settings.reply_timeout = std::chrono::minutes(10);
  settings.stop_timeout = std::chrono::minutes(10);
  settings.supervision_period = std::chrono::minutes(10);
  settings.retry_min = settings.retry_max = std::chrono::minutes(10);
  return settings;
}

/// A commander in some state, with whatever is at its other end.
struct Session {
  std::unique_ptr<Robot> robot;
  boost::asio::io_context context;
  std::unique_ptr<boost::asio::ip::tcp::acceptor> listener;
  std::unique_ptr<boost::asio::ip::tcp::socket> filler;
  std::unique_ptr<Commander> commander;

  void listen() {
    listener = std::make_unique<boost::asio::ip::tcp::acceptor>(
        context, boost::asio::ip::tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0), false);
  }
  [[nodiscard]] int port() const { return listener->local_endpoint().port(); }

  void meet() { commander = std::make_unique<Commander>(0, patient()); }
  blocks::GoalId tryPort(int port) {
    meet();
    return commander->submit(blocks::ConnectGoal{"127.0.0.1", port, 300, {}});
  }
  void beReady() {
    robot = std::make_unique<Robot>(1);
    commander = std::make_unique<Commander>(robot->ports().status, patient());
    (void)commander->connect(robot->ports());
  }
  blocks::GoalId move() {
    const auto goal = commander->submit(endlessMove());
    EXPECT_TRUE(commander->reaches(goal, blocks::Phase::Active));
    return goal;
  }
  void fault(const std::string& name) {
    robot->operate([name](auto& controller, Instant now) {
      EXPECT_TRUE(controller.operate(simulator::SetFault{name, true, 0, 0, {}}, now).done);
    });
    (void)robot->state();  // it has happened
  }
};

struct SessionState {
  const char* name;
  std::function<void(Session&)> reach;
};

inline void PrintTo(const SessionState& state, std::ostream* out) {
  *out << state.name;
}

inline const std::vector<SessionState>& sessionStates() {
  using blocks::Phase;
  using command::CommandStatus;
  static const std::vector<SessionState> states = {
      {"idle", [](Session& session) { session.meet(); }},
      {"looking_up_a_name",
       [](Session& session) {
         session.meet();
         session.commander->submit(blocks::ConnectGoal{"no-such-robot.invalid", 5890, 300, {}});
       }},
      {"trying_where_nobody_answers",
       [](Session& session) {
         session.listen();
         session.listener->listen(0);
         session.filler = std::make_unique<boost::asio::ip::tcp::socket>(session.context);
         session.filler->connect(session.listener->local_endpoint());
         const auto goal = session.tryPort(session.port());
         EXPECT_TRUE(session.commander->reaches(goal, Phase::Connecting));
       }},
      {"backing_off_from_a_refusal",
       [](Session& session) {
         int port = 0;
         {
           const Robot gone(1);
           port = gone.ports().script;
         }
         const auto goal = session.tryPort(port);
         EXPECT_TRUE(session.commander->waitFor<command::GoalProgressed>([&](const auto& progressed) {
           return progressed.goal == goal && progressed.progress.text.find("refused") != std::string::npos;
         }));
       }},
      {"probing_a_silent_peer",
       [](Session& session) {
         session.listen();
         session.listener->listen();
         const auto goal = session.tryPort(session.port());
         EXPECT_TRUE(session.commander->reaches(goal, Phase::Probing));
       }},
      {"ready", [](Session& session) { session.beReady(); }},
      {"in_motion",
       [](Session& session) {
         session.beReady();
         session.move();
       }},
      {"in_motion_with_a_silent_robot",
       [](Session& session) {
         session.beReady();
         session.move();
         session.fault("silence");
       }},
      {"stopping",
       [](Session& session) {
         session.beReady();
         const auto goal = session.move();
         session.fault("ignore_stop");
         session.commander->cancel(goal);
         EXPECT_TRUE(session.commander->reaches(goal, Phase::Stopping));
       }},
      {"leaving_the_listen_node",
       [](Session& session) {
         session.beReady();
         session.fault("drop_entry");
         const auto left = session.commander->run(blocks::ExitListenNodeGoal{});
         EXPECT_TRUE(left && left->ending == blocks::Ending::Done);
         EXPECT_TRUE(session.commander->waitFor<command::StatusChanged>([](const auto& changed) {
           return changed.status.link == CommandStatus::LinkState::NotListening;
         }));
       }},
      {"with_the_robot_gone",
       [](Session& session) {
         session.beReady();
         session.move();
         session.robot->powerOff();
       }},
  };
  return states;
}

}  // namespace cobot_command::runtime
