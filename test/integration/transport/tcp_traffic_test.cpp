#include <algorithm>
#include <random>

#include "network.h"
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>

namespace cobot_command::transport {
namespace {

using boost::asio::ip::tcp;

std::string noise(std::size_t size) {
  std::mt19937 random(20240607);
  std::string bytes(size, '\0');
  std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random() & 0xff); });
  return bytes;
}

/// A peer made of a bare socket, to do what a well-behaved one does not.
tcp::socket rawPeer(boost::asio::io_context& context, std::uint16_t port) {
  tcp::socket socket(context);
  socket.connect({boost::asio::ip::address_v4::loopback(), port});
  return socket;
}

class TcpTrafficTest : public Network {
 protected:
  /// So many bytes at least, in small pieces.
  std::string readSlowly(tcp::socket& peer, std::size_t size) {
    peer.non_blocking(true);
    std::string received;
    std::string piece(20'000, ' ');
    EXPECT_TRUE(runUntil([&] {
      boost::system::error_code code;
      received.append(piece, 0, peer.read_some(boost::asio::buffer(piece), code));
      return received.size() >= size;
    }));
    return received;
  }
};

TEST_F(TcpTrafficTest, carriesAnyBytesOfAnySizeBothWays) {
  const std::string bytes = noise(8'000'000);
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  const ClientId id = server.clients.front();
  client.connection.send(bytes);
  server.tcp.send(id, bytes);
  ASSERT_TRUE(runUntil(
      [&] { return client.received.size() >= bytes.size() && server.received[id].size() >= bytes.size(); }));
  EXPECT_TRUE(client.received == bytes);
  EXPECT_TRUE(server.received[id] == bytes);
}

TEST_F(TcpTrafficTest, keepsTheOrderOfManySmallSends) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  std::string sent;
  for (int i = 0; i < 20000; ++i) {
    const std::string piece = std::to_string(i) + ",";
    client.connection.send(piece);
    sent += piece;
  }
  auto& received = server.received[server.clients.front()];
  ASSERT_TRUE(runUntil([&] { return received.size() >= sent.size(); }));
  EXPECT_TRUE(received == sent);
}

TEST_F(TcpTrafficTest, handsOverEveryByteOfAPeerThatSendsThemOneByOne) {
  Server server(context);
  auto peer = rawPeer(context, server.port);
  peer.set_option(tcp::no_delay(true));
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1; }));
  auto& received = server.received[server.clients.front()];
  const std::string bytes = "$TMSTA,2,00,*41\r\n";
  for (const char byte : bytes) {
    const auto before = received.size();
    boost::asio::write(peer, boost::asio::buffer(&byte, 1));
    ASSERT_TRUE(runUntil([&] { return received.size() == before + 1; }));
  }
  EXPECT_EQ(received, bytes);
}

TEST_F(TcpTrafficTest, handsOverTheLastBytesBeforeItTellsTheEnd) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  const std::string bytes = noise(100'000);
  server.tcp.send(server.clients.front(), bytes);
  server.tcp.closeClient(server.clients.front());
  ASSERT_TRUE(runUntil([&] { return client.closed.has_value(); }));
  EXPECT_TRUE(client.received == bytes);
  EXPECT_EQ(*client.closed, "closed by the peer");
}

TEST_F(TcpTrafficTest, answersAPeerThatHasFinishedSending) {
  std::optional<TcpServer> server;
  server.emplace(context,
                 TcpServer::Callbacks{[](ClientId) {},
                                      [&](ClientId id, std::string_view) { server->send(id, "answer"); },
                                      [](ClientId, const std::string&) {}});
  const auto port = server->bind("127.0.0.1", 0);
  ASSERT_TRUE(port && server->open());
  auto peer = rawPeer(context, *port);
  boost::asio::write(peer, boost::asio::buffer("question", 8));
  peer.shutdown(tcp::socket::shutdown_send);
  peer.non_blocking(true);
  std::string answer(6, ' ');
  ASSERT_TRUE(runUntil([&] {
    boost::system::error_code code;
    return peer.read_some(boost::asio::buffer(answer), code) > 0;
  }));
  EXPECT_EQ(answer, "answer");
}

TEST_F(TcpTrafficTest, tellsOnceThatThePeerResetTheConnection) {
  Server server(context);
  auto peer = rawPeer(context, server.port);
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1; }));
  peer.set_option(tcp::socket::linger(true, 0));
  peer.close();  // sends a reset
  ASSERT_TRUE(runUntil([&] { return server.disconnected.size() == 1; }));
  EXPECT_EQ(server.disconnected.begin()->first, server.clients.front());
  EXPECT_NE(server.disconnected.begin()->second, "closed by the peer");
  EXPECT_FALSE(server.disconnected.begin()->second.empty());
  server.tcp.send(server.clients.front(), "to nobody");
  settle(context);
}

TEST_F(TcpTrafficTest, isNotSentAfterClose) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  client.connection.close();
  client.connection.send("late");
  ASSERT_TRUE(runUntil([&] { return server.disconnected.size() == 1; }));
  EXPECT_EQ(server.received[server.clients.front()], "");
  EXPECT_FALSE(client.connection.isOpen());
}

TEST_F(TcpTrafficTest, isNotSentBeforeOpen) {
  Server server(context);
  Client client(context);
  client.connection.send("early");
  client.open(server.port);
  client.connection.send("early");
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1 && client.opened == 1; }));
  client.connection.send("now");
  ASSERT_TRUE(runUntil([&] { return !server.received[server.clients.front()].empty(); }));
  EXPECT_EQ(server.received[server.clients.front()], "now");
}

TEST_F(TcpTrafficTest, survivesSendingToAPeerThatIsGone) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  client.connection.close();
  for (int i = 0; i < 100; ++i) {  // written before the end is noticed: no signal, no callback from within
    server.tcp.send(server.clients.front(), noise(1000));
  }
  EXPECT_TRUE(server.disconnected.empty());
  EXPECT_TRUE(runUntil([&] { return server.disconnected.size() == 1; }));
}

TEST_F(TcpTrafficTest, dropsAPeerThatNeverReadsInsteadOfGrowingForEver) {
  const std::size_t limit = 100'000;
  Server server(context, limit);
  auto peer = rawPeer(context, server.port);
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1; }));
  const std::string message(50'000, 'x');
  std::size_t most = 0;
  ASSERT_TRUE(runUntil([&] {
    server.tcp.send(server.clients.front(), message);
    most = std::max(most, server.tcp.backlog());
    return !server.disconnected.empty();
  }));
  EXPECT_LE(most, limit + message.size());
  EXPECT_GT(most, limit);
  EXPECT_NE(server.disconnected.begin()->second.find("does not read"), std::string::npos);
  EXPECT_EQ(server.tcp.backlog(), 0u);
}

TEST_F(TcpTrafficTest, carriesTwoPvtsOfAPathAndAStopToAPeerThatReadsLate) {
  Server server(context);
  auto peer = rawPeer(context, server.port);
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1; }));
  const ClientId id = server.clients.front();
  std::string sent;
  const auto send = [&](const std::string& bytes) {
    server.tcp.send(id, bytes);
    sent += bytes;
  };
  // What the system takes is not to count.
  while (server.tcp.backlog() == 0) send(std::string(20'000, 'x'));
  const std::string line =
      "PVTPoint(-179.99999,-179.99999,-154.99999,-179.99999,-179.99999,-269.99999,"
      "-179.99999,-179.99999,-179.99999,-224.99999,-224.99999,-224.99999,0.025)\r\n";
  ASSERT_LE(line.size(), 150U);
  std::string block;
  for (int i = 0; i < 5000; ++i) block += line;
  send(block);
  send(block);
  send("$TMSCT,21,9,StopAndClearBuffer(),*00\r\n");
  EXPECT_GT(server.tcp.backlog(), 2 * block.size());
  settle(context);
  EXPECT_TRUE(server.disconnected.empty()) << server.disconnected.begin()->second;

  EXPECT_TRUE(readSlowly(peer, sent.size()) == sent);
  EXPECT_TRUE(server.disconnected.empty());
}

TEST_F(TcpTrafficTest, keepsAPeerThatReadsSlowlyButReads) {
  Server server(context);
  auto peer = rawPeer(context, server.port);
  ASSERT_TRUE(runUntil([&] { return server.clients.size() == 1; }));
  const std::string bytes = noise(6'000'000);
  server.tcp.send(server.clients.front(), bytes);
  EXPECT_GT(server.tcp.backlog(), 0u);
  EXPECT_TRUE(readSlowly(peer, bytes.size()) == bytes);
  EXPECT_TRUE(server.disconnected.empty());
}

}  // namespace
}  // namespace cobot_command::transport
