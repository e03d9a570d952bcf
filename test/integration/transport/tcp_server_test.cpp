#include "network.h"
#include "process_counts.h"
#include <boost/asio/ip/tcp.hpp>

namespace cobot_command::transport {
namespace {

using TcpServerTest = Network;

TcpServer::Callbacks deaf() {
  return {[](ClientId) {}, [](ClientId, std::string_view) {}, [](ClientId, const std::string&) {}};
}

TEST_F(TcpServerTest, refusesClientsUntilItIsOpen) {
  TcpServer server(context, deaf());
  const auto port = server.bind("127.0.0.1", 0);
  ASSERT_TRUE(port.has_value());
  EXPECT_NE(*port, 0);
  EXPECT_FALSE(server.isOpen());
  Client early(context);
  early.open(*port);
  ASSERT_TRUE(runUntil([&] { return early.failure.has_value(); }));
  EXPECT_EQ(early.failure->kind, NetworkError::Kind::Refused);

  ASSERT_TRUE(server.open().has_value());
  EXPECT_TRUE(server.isOpen());
  Client client(context);
  client.open(*port);
  EXPECT_TRUE(runUntil([&] { return client.opened == 1; }));
}

TEST_F(TcpServerTest, dropsItsClientsAndRefusesNewOnesOnceClosed) {
  Server server(context);
  Client client(context);
  ASSERT_TRUE(join(client, server));
  server.tcp.close();
  EXPECT_FALSE(server.tcp.isOpen());
  ASSERT_TRUE(runUntil([&] { return client.closed.has_value(); }));
  Client late(context);
  late.open(server.port);
  ASSERT_TRUE(runUntil([&] { return late.failure.has_value(); }));
  EXPECT_EQ(late.failure->kind, NetworkError::Kind::Refused);
  EXPECT_TRUE(server.disconnected.empty()) << "a callback after close()";
}

TEST_F(TcpServerTest, opensAgainOnTheSamePortHoweverOften) {
  Server server(context);
  const auto cycle = [&] {
    server.tcp.close();
    ASSERT_TRUE(server.tcp.open().has_value());
    Client client(context);
    ASSERT_TRUE(join(client, server));
    client.connection.send("hello");
    ASSERT_TRUE(runUntil([&] { return server.received[server.clients.back()] == "hello"; }));
  };
  cycle();
  settle(context);
  const int before = testing::openDescriptors();
  for (int i = 0; i < 100; ++i) {
    cycle();
  }
  settle(context);
  EXPECT_EQ(testing::openDescriptors(), before);
}

TEST_F(TcpServerTest, doesNotServeAClientThatCameJustBeforeItWasClosedAndReopened) {
  Server server(context);
  Client client(context);
  client.open(server.port);
  context.restart();
  context.poll_one();
  server.tcp.close();
  server.clients.clear();
  ASSERT_TRUE(server.tcp.open().has_value());
  ASSERT_TRUE(runUntil([&] { return client.closed || client.failure || server.clients.size() == 1; }));
  settle(context);
  EXPECT_EQ(client.connection.isOpen(), server.clients.size() == 1) << "both ends must agree";
}

TEST_F(TcpServerTest, openingTwiceIsHarmless) {
  Server server(context);
  EXPECT_TRUE(server.tcp.open().has_value());
  Client client(context);
  EXPECT_TRUE(join(client, server));
}

TEST_F(TcpServerTest, saysThatAPortIsTaken) {
  const Server first(context);
  TcpServer second(context, deaf());
  const auto bound = second.bind("127.0.0.1", first.port);
  ASSERT_FALSE(bound.has_value());
  EXPECT_EQ(bound.error().kind, NetworkError::Kind::AddressInUse);
}

TEST_F(TcpServerTest, saysThatAnAddressIsNone) {
  for (const char* address : {"not an address", "", "300.0.0.1", "192.0.2.1"}) {
    TcpServer server(context, deaf());
    const auto bound = server.bind(address, 0);
    ASSERT_FALSE(bound.has_value()) << address;
    EXPECT_EQ(bound.error().kind, NetworkError::Kind::BadAddress) << address << ": " << bound.error().message;
  }
}

TEST_F(TcpServerTest, tellsItsClientsApart) {
  Server server(context);
  Client first(context);
  Client second(context);
  ASSERT_TRUE(join(first, server));
  ASSERT_TRUE(join(second, server));
  const ClientId one = server.clients[0];
  const ClientId two = server.clients[1];
  EXPECT_NE(one, two);
  first.connection.send("1");
  second.connection.send("2");
  ASSERT_TRUE(runUntil([&] { return !server.received[one].empty() && !server.received[two].empty(); }));
  EXPECT_EQ(server.received[one], "1");
  EXPECT_EQ(server.received[two], "2");
  server.tcp.send(two, "for the second");
  ASSERT_TRUE(runUntil([&] { return second.received == "for the second"; }));
  EXPECT_EQ(first.received, "");
}

TEST_F(TcpServerTest, givesEachClientOfTheProcessAnIdOfItsOwn) {
  Server one(context);
  Server other(context);
  Client first(context);
  Client second(context);
  ASSERT_TRUE(join(first, one));
  ASSERT_TRUE(join(second, other));
  EXPECT_NE(one.clients.front(), other.clients.front());
}

TEST_F(TcpServerTest, dropsOneClientAndKeepsTheOthers) {
  Server server(context);
  Client dropped(context);
  Client kept(context);
  ASSERT_TRUE(join(dropped, server));
  ASSERT_TRUE(join(kept, server));
  server.tcp.send(server.clients[0], "last words");
  server.tcp.closeClient(server.clients[0]);
  ASSERT_TRUE(runUntil([&] { return dropped.closed.has_value(); }));
  EXPECT_EQ(dropped.received, "last words");
  server.tcp.send(server.clients[0], "to nobody");
  server.tcp.send(server.clients[1], "still here");
  ASSERT_TRUE(runUntil([&] { return kept.received == "still here"; }));
  EXPECT_TRUE(server.disconnected.empty()) << "a callback for a client that was closed here";
}

TEST_F(TcpServerTest, mayBeClosedByItsOwnCallbacks) {
  TcpServer* self = nullptr;
  int called = 0;
  TcpServer server(context,
                   {[&](ClientId) { ++called, self->close(); }, [&](ClientId, std::string_view) { ++called; },
                    [&](ClientId, const std::string&) { ++called; }});
  self = &server;
  const auto port = server.bind("127.0.0.1", 0);
  ASSERT_TRUE(port && server.open());
  Client client(context);
  client.open(*port);
  ASSERT_TRUE(runUntil([&] { return client.closed.has_value(); }));
  EXPECT_EQ(called, 1);
}

}  // namespace
}  // namespace cobot_command::transport
