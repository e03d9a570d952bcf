// A TCP server that can be closed and opened again on the same port, with any number of clients.
//
// Owns its sockets; the io_context is the caller's and must outlive it. Not thread-safe: every call, and
// every callback, belongs to the one thread that runs the io_context. Callbacks come only from the running
// io_context, never from inside a call, and none comes for a client that was closed here, nor after close()
// or destruction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "cobot_command/common/result.h"
#include "cobot_command/transport/limits.h"
#include "cobot_command/transport/network_error.h"

namespace boost::asio {
class io_context;
}

namespace cobot_command::transport {

/// Unique among all servers of the process; never used twice.
using ClientId = std::uint64_t;

class TcpServer {
 public:
  /// All are set.
  struct Callbacks {
    std::function<void(ClientId)> connected;
    std::function<void(ClientId, std::string_view bytes)> received;  ///< in pieces of any size
    /// The client went away, or was dropped because it reads too slowly.
    std::function<void(ClientId, const std::string& reason)> disconnected;
  };

  TcpServer(boost::asio::io_context& context, Callbacks callbacks, std::size_t send_limit = kSendLimit);
  ~TcpServer();
  TcpServer(const TcpServer&) = delete;
  TcpServer& operator=(const TcpServer&) = delete;

  /// Takes the port (0: any free one) and keeps it until destruction, also while closed; returns its number.
  /// Nobody is served yet: clients are refused. Precondition: called once, before open().
  [[nodiscard]] Result<std::uint16_t, NetworkError> bind(const std::string& address, std::uint16_t port);

  /// Serves clients from now on. Harmless when open already.
  [[nodiscard]] Result<void, NetworkError> open();

  /// Drops all clients; new ones are refused until open().
  void close();

  [[nodiscard]] bool isOpen() const;

  /// What the system takes at once is on its way when this returns; the rest is kept and follows. An unknown
  /// id is a client that has gone: nothing is done.
  void send(ClientId client, std::string_view bytes);
  void closeClient(ClientId client);
  /// The address that the client connected from, as "127.0.0.1"; empty when it has gone.
  [[nodiscard]] std::string addressOf(ClientId client) const;

  /// Bytes kept for the slowest client.
  [[nodiscard]] std::size_t backlog() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace cobot_command::transport
