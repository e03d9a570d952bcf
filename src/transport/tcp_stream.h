// An open TCP connection, on whichever side: reads what comes, sends what it is given, bounded.
//
// Threads and callbacks as in TcpConnection. Pending operations keep the object alive, so it may be let go
// from within its own callbacks.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include <boost/asio/ip/tcp.hpp>

namespace cobot_command::transport {

class TcpStream : public std::enable_shared_from_this<TcpStream> {
 public:
  struct Callbacks {
    std::function<void(std::string_view bytes)> received;
    std::function<void(const std::string& reason)> closed;
  };

  TcpStream(boost::asio::ip::tcp::socket socket, std::size_t send_limit, Callbacks callbacks);

  void start();
  void send(std::string_view bytes);
  void close();
  [[nodiscard]] std::size_t backlog() const { return outbox_.size(); }
  /// Of the peer; empty when the connection has ended.
  [[nodiscard]] std::string peerAddress() const;

 private:
  void read();
  void write();
  void giveUp(const boost::system::error_code& code);
  [[nodiscard]] std::string reasonOf(const boost::system::error_code& read_failure) const;
  void end(const std::string& reason);

  boost::asio::ip::tcp::socket socket_;
  const std::size_t send_limit_;
  const Callbacks callbacks_;
  std::array<char, std::size_t{16} * 1024> inbox_{};
  std::string outbox_;
  bool waiting_to_write_ = false;
  boost::system::error_code write_failure_;
};

}  // namespace cobot_command::transport
