#include <memory>

#include "network.h"
#include "process_counts.h"
#include <boost/asio/ip/tcp.hpp>
#include <sys/socket.h>

namespace cobot_command::transport {
namespace {

using boost::asio::ip::tcp;
using std::chrono::milliseconds;

/// Listens, and has no room for one more client: what it is asked, it does not answer.
class BlackHole {
 public:
  explicit BlackHole(boost::asio::io_context& context) : acceptor_(context, {tcp::v4(), 0}, false) {
    acceptor_.listen(0);
    for (int i = 0; i < 4; ++i) {
      tcp::endpoint self(boost::asio::ip::address_v4::loopback(), port());
      fillers_.emplace_back(context, tcp::v4());
      fillers_.back().native_non_blocking(true);
      ::connect(fillers_.back().native_handle(), self.data(), static_cast<socklen_t>(self.size()));
    }
  }
  [[nodiscard]] std::uint16_t port() const { return acceptor_.local_endpoint().port(); }

 private:
  tcp::acceptor acceptor_;
  std::vector<tcp::socket> fillers_;
};

/// A port on which nobody listens, and that nobody else can take.
class ClosedPort {
 public:
  explicit ClosedPort(boost::asio::io_context& context)
      : server_(context,
                {[](ClientId) {}, [](ClientId, std::string_view) {}, [](ClientId, const std::string&) {}}),
        port_(server_.bind("127.0.0.1", 0).value_or(0)) {}
  [[nodiscard]] std::uint16_t port() const { return port_; }

 private:
  TcpServer server_;
  std::uint16_t port_;
};

using TcpConnectionTest = Network;

TEST_F(TcpConnectionTest, opensToAListeningServer) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  EXPECT_TRUE(client.connection.isOpen());
  EXPECT_FALSE(client.failure);
}

TEST_F(TcpConnectionTest, opensByName) {
  Server server(context);
  Client client(context);
  client.connection.open("localhost", server.port, kDeadline);
  EXPECT_TRUE(runUntil([&] { return client.opened == 1; }));
}

TEST_F(TcpConnectionTest, saysRefusedWhenNobodyListens) {
  const ClosedPort closed(context);
  Client client(context);
  client.open(closed.port());
  ASSERT_TRUE(runUntil([&] { return client.failure.has_value(); }));
  EXPECT_EQ(client.failure->kind, NetworkError::Kind::Refused) << client.failure->message;
  EXPECT_FALSE(client.failure->message.empty());
}

TEST_F(TcpConnectionTest, saysUnknownHostWhenTheNameCannotBeResolved) {
  Client client(context);
  client.connection.open("no-such-robot.invalid", 5890, kDeadline);
  ASSERT_TRUE(runUntil([&] { return client.failure.has_value(); }));
  EXPECT_EQ(client.failure->kind, NetworkError::Kind::UnknownHost) << client.failure->message;
}

TEST_F(TcpConnectionTest, doesNotTakeAnEmptyNameForThisMachine) {
  Server server(context);
  Client client(context);
  client.connection.open("", server.port, kDeadline);
  ASSERT_TRUE(runUntil([&] { return client.failure.has_value(); }));
  EXPECT_EQ(client.failure->kind, NetworkError::Kind::UnknownHost);
}

TEST_F(TcpConnectionTest, saysUnreachableWhenThereIsNoWay) {
  Client client(context);
  client.connection.open("255.255.255.255", 5890, kDeadline);  // TCP has no broadcast
  ASSERT_TRUE(runUntil([&] { return client.failure.has_value(); }));
  EXPECT_EQ(client.failure->kind, NetworkError::Kind::Unreachable) << client.failure->message;
}

TEST_F(TcpConnectionTest, givesUpWhenTheTimeIsOver) {
  const BlackHole silent(context);
  Client client(context);
  client.open(silent.port(), milliseconds(100));
  ASSERT_TRUE(runUntil([&] { return client.failure.has_value(); }));
  EXPECT_EQ(client.failure->kind, NetworkError::Kind::TimedOut);
}

/// The system may give a try the very port that it tries (TCP simultaneous open). It walks through its even
/// ports for connections, so that this many tries on one of them nearly always meet it.
TEST_F(TcpConnectionTest, isNeverMetByItself) {
  const auto port = [&] { return tcp::acceptor(context, {tcp::v4(), 0}).local_endpoint().port(); }();
  for (int i = 0; i < 30000; ++i) {
    Client client(context);
    client.open(static_cast<std::uint16_t>(port & ~1u));
    ASSERT_TRUE(runUntil([&] { return client.failure || client.opened == 1; }));
    ASSERT_TRUE(client.failure) << "opened at try " << i;
    EXPECT_EQ(client.failure->kind, NetworkError::Kind::Refused);
  }
}

TEST_F(TcpConnectionTest, isQuietAfterItWasClosedWhileOpening) {
  const BlackHole silent(context);
  const ClosedPort closed(context);
  Server server(context);
  for (const auto port : {silent.port(), closed.port(), server.port}) {
    Client client(context);
    client.open(port, milliseconds(1));
    client.connection.close();
    settle(context);
    EXPECT_EQ(client.opened, 0);
    EXPECT_FALSE(client.failure);
    EXPECT_FALSE(client.closed);
  }
}

TEST_F(TcpConnectionTest, isQuietAfterItWasClosedWhileResolving) {
  Client client(context);
  client.connection.open("no-such-robot.invalid", 5890, kDeadline);
  client.connection.close();
  settle(context);
  EXPECT_FALSE(client.failure);
}

TEST_F(TcpConnectionTest, isQuietAfterItWasClosedWithNewsUnderWay) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  server.tcp.send(server.clients.front(), "too late");
  server.tcp.closeClient(server.clients.front());
  client.connection.close();
  settle(context);
  EXPECT_EQ(client.received, "");
  EXPECT_FALSE(client.closed);
}

TEST_F(TcpConnectionTest, mayBeDestroyedByItsOwnCallbacks) {
  Server server(context);
  const ClosedPort closed(context);
  std::unique_ptr<TcpConnection> connection;
  int gone = 0;
  const auto destroy = [&] {
    connection.reset();
    ++gone;
  };
  const auto ignore = [](auto&&...) {};
  const auto open = [&](TcpConnection::Callbacks callbacks, std::uint16_t port) {
    connection = std::make_unique<TcpConnection>(context, std::move(callbacks));
    connection->open("127.0.0.1", port, kDeadline);
  };

  open({destroy, ignore, ignore, ignore}, server.port);
  ASSERT_TRUE(runUntil([&] { return gone == 1; }));
  open({ignore, [&](const NetworkError&) { destroy(); }, ignore, ignore}, closed.port());
  ASSERT_TRUE(runUntil([&] { return gone == 2; }));
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1; }));
  open({ignore, ignore, [&](std::string_view) { destroy(); }, ignore}, server.port);
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 2; }));
  server.tcp.send(server.clients.back(), "bytes");
  ASSERT_TRUE(runUntil([&] { return gone == 3; }));
  open({ignore, ignore, ignore, [&](const std::string&) { destroy(); }}, server.port);
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 3; }));
  server.tcp.closeClient(server.clients.back());
  EXPECT_TRUE(runUntil([&] { return gone == 4; }));
}

TEST_F(TcpConnectionTest, leavesNoDescriptorBehindInAHundredConnections) {
  Server server(context);
  const ClosedPort closed(context);
  const BlackHole silent(context);
  const auto cycle = [&] {
    Client served(context);
    ASSERT_TRUE(join(served, server));
    Client refused(context);
    refused.open(closed.port());
    Client unanswered(context);
    unanswered.open(silent.port(), milliseconds(1));
    ASSERT_TRUE(runUntil([&] { return refused.failure && unanswered.failure; }));
    server.tcp.closeClient(server.clients.back());
    ASSERT_TRUE(runUntil([&] { return served.closed.has_value(); }));
  };
  cycle();
  const int before = testing::openDescriptors();
  for (int i = 0; i < 100; ++i) {
    cycle();
  }
  EXPECT_EQ(testing::openDescriptors(), before);
}

TEST(TcpConnectionEnd, isQuickInEveryState) {
  const auto start = std::chrono::steady_clock::now();
  {
    boost::asio::io_context context;
    const BlackHole silent(context);
    Server server(context);
    Client unopened(context);
    Client resolving(context);
    resolving.connection.open("no-such-robot.invalid", 5890, kDeadline);
    Client connecting(context);
    connecting.open(silent.port());
    Client open(context);
    open.open(server.port);
    ASSERT_TRUE(runUntil(context, [&] { return open.opened == 1; }));
    open.connection.send(std::string(10'000'000, 'x'));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, kDeadline);
}

}  // namespace
}  // namespace cobot_command::transport
