// The proxy itself: frames pass it unchanged, and each fault does what its name says.
#include "fault_proxy.h"

#include "network.h"
#include <gmock/gmock.h>

#include "cobot_command/protocol/frame.h"

namespace cobot_command::testing {
namespace {

using namespace std::chrono_literals;
using Port = FaultProxy::Port;
using transport::Client;
using transport::Server;

const std::string kQuestion = protocol::encodeFrame("TMSTA", "00");
const std::string kAnswer = protocol::encodeFrame("TMSTA", "00,true,Listen1");
const std::string kReply = protocol::encodeFrame("TMSCT", "4,OK");
const std::string kItems = protocol::encodeFrame("TMSVR", std::string("0,1,\x03\0abc\x01\0\xff", 12));

class Proxied : public transport::Network {
 protected:
  Fault with(FaultKind kind, Direction direction = Direction::ToClient) {
    Fault fault;
    fault.kind = kind;
    fault.direction = direction;
    return fault;
  }
  void open(Client& some) { some.open(static_cast<std::uint16_t>(proxy.ports().script)); }
  /// The client is connected through the proxy.
  void SetUp() override {
    open(client);
    ASSERT_TRUE(runUntil([&] { return client.opened == 1 && script.clients.size() == 1; }));
  }
  void say(const std::string& bytes) { script.tcp.send(script.clients.back(), bytes); }
  [[nodiscard]] const std::string& heard() { return script.received[script.clients.back()]; }
  [[nodiscard]] bool clientReads(const std::string& bytes) {
    return runUntil([&] { return client.received == bytes; });
  }

  Server script{context};
  Server status{context};
  FaultProxy proxy{{script.port, status.port}, 1};
  Client client{context};
};

TEST_F(Proxied, framesPassUnchangedInBothDirections) {
  client.connection.send(kQuestion);
  EXPECT_TRUE(runUntil([&] { return heard() == kQuestion; }));
  say(kAnswer + kReply);
  EXPECT_TRUE(clientReads(kAnswer + kReply));
  say("no frame");
  EXPECT_TRUE(clientReads(kAnswer + kReply + "no frame"));
  say(kReply);
  EXPECT_TRUE(clientReads(kAnswer + kReply + "no frame" + kReply));
  EXPECT_EQ(proxy.strikes(), 0u);
}

TEST_F(Proxied, theStatusPortHasFaultsOfItsOwn) {
  Client reader(context);
  reader.open(static_cast<std::uint16_t>(proxy.ports().status));
  ASSERT_TRUE(runUntil([&] { return status.clients.size() == 1; }));
  proxy.add(Port::Script, with(FaultKind::Drop));
  status.tcp.send(status.clients.front(), kItems);
  EXPECT_TRUE(runUntil([&] { return reader.received == kItems; }));
  proxy.add(Port::Status, with(FaultKind::Duplicate));
  status.tcp.send(status.clients.front(), kItems);
  EXPECT_TRUE(runUntil([&] { return reader.received == kItems + kItems + kItems; }));
}

TEST_F(Proxied, endsAreHandedOn) {
  client.connection.close();
  EXPECT_TRUE(runUntil([&] { return script.disconnected.size() == 1; }));
  Client other(context);
  open(other);
  ASSERT_TRUE(runUntil([&] { return script.clients.size() == 2; }));
  script.tcp.closeClient(script.clients.back());
  EXPECT_TRUE(runUntil([&] { return other.closed.has_value(); }));
  EXPECT_TRUE(runUntil([&] { return proxy.connections() == 0; }));
}

TEST_F(Proxied, aBlackHoleLetsNothingThroughUntilItIsHealed) {
  proxy.add(Port::Script, with(FaultKind::Drop));
  proxy.add(Port::Script, with(FaultKind::Drop, Direction::ToController));
  client.connection.send(kQuestion);
  say(kAnswer);
  ASSERT_TRUE(runUntil([&] { return proxy.strikes() == 2; }));
  EXPECT_EQ(client.received + heard(), "");
  EXPECT_FALSE(client.closed.has_value());
  proxy.heal();
  say(kReply);
  EXPECT_TRUE(clientReads(kReply));
}

TEST_F(Proxied, refusesNewConnectionsAndKeepsTheOldOnes) {
  proxy.add(Port::Script, with(FaultKind::Refuse));
  Client refused(context);
  open(refused);
  ASSERT_TRUE(runUntil([&] { return refused.failure.has_value(); }));
  EXPECT_EQ(refused.failure->kind, transport::NetworkError::Kind::Refused);
  say(kReply);
  EXPECT_TRUE(clientReads(kReply));
  proxy.heal();
  Client welcome(context);
  open(welcome);
  EXPECT_TRUE(runUntil([&] { return welcome.opened == 1 && script.clients.size() == 2; }));
}

TEST_F(Proxied, leadsNewConnectionsNowhere) {
  proxy.add(Port::Script, with(FaultKind::Silence));
  Client lost(context);
  open(lost);
  ASSERT_TRUE(runUntil([&] { return lost.opened == 1; }));
  lost.connection.send(kQuestion);
  ASSERT_TRUE(runUntil([&] { return proxy.connections() == 2; }));
  EXPECT_EQ(script.clients.size(), 1u);
  proxy.heal();
  EXPECT_TRUE(runUntil([&] { return lost.closed.has_value(); }));
  EXPECT_FALSE(client.closed.has_value());
}

TEST_F(Proxied, closesNewConnectionsAtOnce) {
  proxy.add(Port::Script, with(FaultKind::CloseAtOnce));
  Client turned_away(context);
  open(turned_away);
  EXPECT_TRUE(runUntil([&] { return turned_away.closed.has_value(); }));
  EXPECT_EQ(script.clients.size(), 1u);
}

TEST_F(Proxied, resetsAndClosesAtTheFrameThatIsAskedFor) {
  Fault reset = with(FaultKind::Reset);
  reset.first = 1;
  proxy.add(Port::Script, reset);
  say(kAnswer + kReply);
  ASSERT_TRUE(runUntil([&] { return client.closed.has_value(); }));
  EXPECT_EQ(*client.closed, "Connection reset by peer");
  EXPECT_TRUE(runUntil([&] { return script.disconnected.size() == 1; }));

  proxy.heal();
  Client orderly(context);
  open(orderly);
  ASSERT_TRUE(runUntil([&] { return script.clients.size() == 2; }));
  Fault close = with(FaultKind::Close);
  close.first = 1;
  proxy.add(Port::Script, close);
  say(kAnswer + kReply);
  ASSERT_TRUE(runUntil([&] { return orderly.closed.has_value(); }));
  EXPECT_EQ(orderly.received, kAnswer);
  EXPECT_EQ(*orderly.closed, "closed by the peer");
  EXPECT_TRUE(runUntil([&] { return script.disconnected.size() == 2; }));
}

TEST_F(Proxied, leavesUnreadWhatItIsToLeaveUnread) {
  proxy.add(Port::Script, with(FaultKind::NeverRead, Direction::ToController));
  client.connection.send(kQuestion);
  say(kReply);
  ASSERT_TRUE(clientReads(kReply));
  EXPECT_EQ(heard(), "");
  proxy.heal();
  EXPECT_TRUE(runUntil([&] { return heard() == kQuestion; }));
}

TEST_F(Proxied, delaysInOrderAndOvertakes) {
  Fault delay = with(FaultKind::Delay);
  delay.time = 100ms;
  delay.count = 1;
  proxy.add(Port::Script, delay);
  const auto start = std::chrono::steady_clock::now();
  say(kReply + kAnswer);
  EXPECT_TRUE(clientReads(kReply + kAnswer));
  EXPECT_GE(std::chrono::steady_clock::now() - start, 100ms);
  client.received.clear();
  proxy.heal();
  Fault overtaken = delay;
  overtaken.kind = FaultKind::Overtaken;
  proxy.add(Port::Script, overtaken);
  say(kReply + kAnswer);
  EXPECT_TRUE(clientReads(kAnswer + kReply));
}

/// Counts the pieces in which bytes arrive.
struct PieceCounter {
  explicit PieceCounter(boost::asio::io_context& context)
      : connection(context, {[] {}, [](const transport::NetworkError&) {},
                             [this](std::string_view piece) {
                               ++pieces;
                               bytes += piece.size();
                             },
                             [](const std::string&) {}}) {}

  int pieces = 0;
  std::size_t bytes = 0;
  transport::TcpConnection connection;
};

TEST_F(Proxied, mergesWhatComesTogether) {
  PieceCounter counter(context);
  counter.connection.open("127.0.0.1", static_cast<std::uint16_t>(proxy.ports().script), 10s);
  ASSERT_TRUE(runUntil([&] { return script.clients.size() == 2; }));
  Fault merge = with(FaultKind::Merge);
  merge.time = 300ms;
  proxy.add(Port::Script, merge);
  for (int i = 0; i < 20; ++i) say(kReply);
  EXPECT_TRUE(runUntil([&] { return counter.bytes == 20 * kReply.size(); }));
  EXPECT_LE(counter.pieces, 2);
}

TEST_F(Proxied, trickles) {
  Fault trickle = with(FaultKind::ByteByByte);
  trickle.rate = 200;
  proxy.add(Port::Script, trickle);
  const auto start = std::chrono::steady_clock::now();
  say(kReply);
  EXPECT_TRUE(clientReads(kReply));
  EXPECT_GE(std::chrono::steady_clock::now() - start, 5ms * kReply.size());
}

TEST_F(Proxied, answersInTheNameOfTheController) {
  proxy.add(Port::Script, with(FaultKind::AnswerFirst, Direction::ToController));
  client.connection.send(protocol::encodeFrame("TMSCT", "4,Pause()"));
  EXPECT_TRUE(clientReads(kReply));
  EXPECT_TRUE(runUntil([&] { return heard() == protocol::encodeFrame("TMSCT", "4,Pause()"); }));
}

}  // namespace
}  // namespace cobot_command::testing
