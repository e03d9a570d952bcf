// A TCP server for any number of clients. It can be closed and opened again on the same port.
//
// Owns its sockets. The caller owns the io_context, which must outlive the server. Not thread-safe: all calls
// and callbacks must run in the one thread that runs the io_context. Callbacks are invoked only by the
// running io_context, never inside a call, never for a client that was closed here, and never after close()
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

/// Unique among all servers of the process; never reused.
using ClientId = std::uint64_t;

class TcpServer {
 public:
  /// All must be set.
  struct Callbacks {
    std::function<void(ClientId)> connected;
    std::function<void(ClientId, std::string_view bytes)> received;  ///< in pieces of any size
    /// The client has disconnected, or was disconnected because it reads too slowly.
    std::function<void(ClientId, const std::string& reason)> disconnected;
  };

  TcpServer(boost::asio::io_context& context, Callbacks callbacks, std::size_t send_limit = kSendLimit);
  ~TcpServer();
  TcpServer(const TcpServer&) = delete;
  TcpServer& operator=(const TcpServer&) = delete;

  /// Reserves the port (0: any free one) until destruction, also while closed, and returns its number.
  /// Clients are refused until open(). Precondition: called once, before open().
  [[nodiscard]] Result<std::uint16_t, NetworkError> bind(const std::string& address, std::uint16_t port);

  /// Accepts clients from now on. No effect if already open.
  [[nodiscard]] Result<void, NetworkError> open();

  /// Disconnects all clients. New ones are refused until open().
  void close();

  [[nodiscard]] bool isOpen() const;

  /// Bytes that the operating system accepts immediately are sent when this returns; the rest is stored and
  /// sent later. Ignored for an unknown id, which is a client that has disconnected.
  void send(ClientId client, std::string_view bytes);
  void closeClient(ClientId client);
  /// The address of the client, as "127.0.0.1"; empty if it has disconnected.
  [[nodiscard]] std::string addressOf(ClientId client) const;

  /// Bytes stored for the slowest client.
  [[nodiscard]] std::size_t backlog() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace cobot_command::transport
