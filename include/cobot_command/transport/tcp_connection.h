// One outgoing TCP connection. Opening has a deadline; closing is possible at any time.
//
// Owns its socket. The caller owns the io_context, which must outlive the connection. Not thread-safe: all
// calls and callbacks must run in the one thread that runs the io_context. Callbacks are invoked only by the
// running io_context, never inside a call, and never after close() or destruction. A callback may close or
// destroy its own connection.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "cobot_command/common/time.h"
#include "cobot_command/transport/limits.h"
#include "cobot_command/transport/network_error.h"

namespace boost::asio {
class io_context;
}

namespace cobot_command::transport {

class TcpConnection {
 public:
  /// After open() exactly one of opened and failed is called. The others are never called before opened. All
  /// must be set.
  struct Callbacks {
    std::function<void()> opened;
    std::function<void(const NetworkError&)> failed;
    std::function<void(std::string_view bytes)> received;  ///< in pieces of any size
    /// The connection has ended: by the peer, by the network, or because the peer reads too slowly.
    std::function<void(const std::string& reason)> closed;
  };

  TcpConnection(boost::asio::io_context& context, Callbacks callbacks, std::size_t send_limit = kSendLimit);
  ~TcpConnection();
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;

  /// Resolves the name and tries its addresses one after the other, all within `timeout`. Precondition:
  /// called once.
  void open(const std::string& host, std::uint16_t port, Duration timeout);

  /// Bytes that the operating system accepts immediately are sent when this returns; the rest is stored and
  /// sent later. Ignored unless the connection is open.
  void send(std::string_view bytes);

  /// Ends everything immediately, including a connection that is still being opened.
  void close();

  [[nodiscard]] bool isOpen() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace cobot_command::transport
