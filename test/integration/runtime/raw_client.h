// A client of the simulator made of a bare socket: it knows bytes only.
#pragma once

#include <chrono>
#include <string>

#include "event_log.h"
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <poll.h>

namespace cobot_command::runtime {

class RawClient {
 public:
  explicit RawClient(int port) : socket_(context_) {
    socket_.connect({boost::asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)}, refused_);
  }
  [[nodiscard]] bool isConnected() const { return !refused_; }

  void send(const std::string& bytes) { boost::asio::write(socket_, boost::asio::buffer(bytes)); }

  /// Reads until the bytes so far contain `expected`; false at the end of the connection or of the deadline.
  [[nodiscard]] bool reads(const std::string& expected) {
    while (received_.find(expected) == std::string::npos) {
      if (!readSome()) {
        return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool readsTheEnd() {
    while (readSome()) {
    }
    return ended_;
  }
  [[nodiscard]] const std::string& received() const { return received_; }

 private:
  bool readSome() {
    pollfd readable{socket_.native_handle(), POLLIN, 0};
    const auto timeout = std::chrono::milliseconds(testing::kDeadline).count();
    if (poll(&readable, 1, static_cast<int>(timeout)) != 1) {
      return false;
    }
    std::string piece(4096, '\0');
    boost::system::error_code code;
    const auto size = socket_.read_some(boost::asio::buffer(piece), code);
    received_.append(piece, 0, size);
    ended_ = static_cast<bool>(code);
    return !ended_;
  }

  boost::asio::io_context context_;
  boost::asio::ip::tcp::socket socket_;
  boost::system::error_code refused_;
  std::string received_;
  bool ended_ = false;
};

}  // namespace cobot_command::runtime
