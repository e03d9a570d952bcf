// One outgoing TCP connection: opened with a deadline, closed at any moment.
//
// Owns its socket; the io_context is the caller's and must outlive it. Not thread-safe: every call, and
// every callback, belongs to the one thread that runs the io_context. Callbacks come only from the running
// io_context, never from inside a call, and none comes after close() or destruction; they may close or
// destroy the connection that calls them.
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
  /// Of opened and failed exactly one follows open(); of the others none comes before opened. All are set.
  struct Callbacks {
    std::function<void()> opened;
    std::function<void(const NetworkError&)> failed;
    std::function<void(std::string_view bytes)> received;  ///< in pieces of any size
    /// The connection ended, by the peer, by the network, or because the peer reads too slowly.
    std::function<void(const std::string& reason)> closed;
  };

  TcpConnection(boost::asio::io_context& context, Callbacks callbacks, std::size_t send_limit = kSendLimit);
  ~TcpConnection();
  TcpConnection(const TcpConnection&) = delete;
  TcpConnection& operator=(const TcpConnection&) = delete;

  /// Resolves the name, tries its addresses one after the other; all of it within `timeout`.
  /// Precondition: called once.
  void open(const std::string& host, std::uint16_t port, Duration timeout);

  /// What the system takes at once is on its way when this returns; the rest is kept and follows. Ignored
  /// unless the connection is open.
  void send(std::string_view bytes);

  /// Ends everything at once, also a connection that is still being opened.
  void close();

  [[nodiscard]] bool isOpen() const;

 private:
  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace cobot_command::transport
