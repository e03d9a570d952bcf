// A loopback network in one thread: a server, clients that remember what happened to them, and a way to let
// the network run until something is true.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <gtest/gtest.h>

#include "cobot_command/transport/tcp_connection.h"
#include "cobot_command/transport/tcp_server.h"

namespace cobot_command::transport {

/// Generous: reached only when something is broken.
inline constexpr auto kDeadline = std::chrono::seconds(20);

/// Lets the network run until `condition` is true; false when it does not become true in time.
template <class Condition>
[[nodiscard]] bool runUntil(boost::asio::io_context& context, Condition condition) {
  const auto end = std::chrono::steady_clock::now() + kDeadline;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    context.restart();
    context.run_one_for(std::chrono::milliseconds(1));
  }
  return true;
}

/// Lets everything happen that is ready to happen.
inline void settle(boost::asio::io_context& context) {
  context.restart();
  context.run_for(std::chrono::milliseconds(20));
}

/// A client that remembers.
struct Client {
  explicit Client(boost::asio::io_context& context)
      : connection(context, {[this] { ++opened; }, [this](const NetworkError& error) { failure = error; },
                             [this](std::string_view bytes) { received.append(bytes); },
                             [this](const std::string& why) { closed = why; }}) {}

  void open(std::uint16_t port, Duration timeout = std::chrono::seconds(10)) {
    connection.open("127.0.0.1", port, timeout);
  }

  int opened = 0;
  std::optional<NetworkError> failure;
  std::string received;
  std::optional<std::string> closed;
  TcpConnection connection;
};

/// A server that remembers.
struct Server {
  explicit Server(boost::asio::io_context& context, std::size_t send_limit = kSendLimit)
      : tcp(context,
            {[this](ClientId id) { clients.push_back(id); },
             [this](ClientId id, std::string_view bytes) { received[id].append(bytes); },
             [this](ClientId id, const std::string& why) { disconnected[id] = why; }},
            send_limit) {
    const auto bound = tcp.bind("127.0.0.1", 0);
    EXPECT_TRUE(bound.has_value());
    port = bound.value_or(0);
    EXPECT_TRUE(tcp.open().has_value());
  }

  std::vector<ClientId> clients;
  std::map<ClientId, std::string> received;
  std::map<ClientId, std::string> disconnected;
  TcpServer tcp;
  std::uint16_t port = 0;
};

class Network : public ::testing::Test {
 protected:
  template <class Condition>
  [[nodiscard]] bool runUntil(Condition condition) {
    return transport::runUntil(context, condition);
  }
  /// Both ends of a new connection know of each other.
  [[nodiscard]] bool join(Client& client, Server& server) {
    const auto before = server.clients.size();
    client.open(server.port);
    return runUntil([&] { return client.opened == 1 && server.clients.size() == before + 1; });
  }

  boost::asio::io_context context;
};

}  // namespace cobot_command::transport
