#include "tcp_stream.h"

#include <utility>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/post.hpp>

namespace cobot_command::transport {
namespace asio = boost::asio;
using boost::asio::ip::tcp;
using boost::system::error_code;

TcpStream::TcpStream(tcp::socket socket, std::size_t send_limit, Callbacks callbacks)
    : socket_(std::move(socket)), send_limit_(send_limit), callbacks_(std::move(callbacks)) {}

void TcpStream::start() {
  error_code ignored;  // a connection that is gone already is reported by the first read
  socket_.set_option(tcp::no_delay(true), ignored);
  socket_.non_blocking(true, ignored);
  read();
}

std::string TcpStream::peerAddress() const {
  boost::system::error_code code;
  const auto address = socket_.remote_endpoint(code).address();
  if (code) return {};
  const bool is_mapped = address.is_v6() && address.to_v6().is_v4_mapped();
  return is_mapped ? asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string()
                   : address.to_string();
}

void TcpStream::read() {
  socket_.async_read_some(asio::buffer(inbox_), [self = shared_from_this()](error_code code, std::size_t n) {
    if (!self->socket_.is_open()) {
      return;
    }
    if (code) {
      self->end(self->reasonOf(code));
      return;
    }
    self->callbacks_.received(std::string_view(self->inbox_.data(), n));
    if (self->socket_.is_open()) {
      self->read();
    }
  });
}

void TcpStream::send(std::string_view bytes) {
  if (!socket_.is_open()) {
    return;
  }
  if (outbox_.size() > send_limit_) {
    asio::post(socket_.get_executor(), [self = shared_from_this()] {
      self->end("the peer does not read: " + std::to_string(self->outbox_.size()) + " bytes wait for it");
    });
    return;
  }
  outbox_.append(bytes);
  if (!waiting_to_write_) {
    write();
  }
}

/// Written at once and not by an asynchronous operation, so that a close() right after it cuts off nothing
/// that the system would have taken.
void TcpStream::write() {
  error_code code;
  while (!outbox_.empty() && !code) {
    outbox_.erase(0, socket_.write_some(asio::buffer(outbox_), code));
  }
  if (code == asio::error::would_block || code == asio::error::try_again) {
    waiting_to_write_ = true;
    socket_.async_wait(tcp::socket::wait_write, [self = shared_from_this()](error_code) {
      self->waiting_to_write_ = false;
      if (self->socket_.is_open()) {
        self->write();
      }
    });
  } else if (code) {
    giveUp(code);
  }
}

/// What could not be written is lost, and with it the sense of the rest. The reader ends the connection,
/// after the last bytes that the peer has sent.
void TcpStream::giveUp(const error_code& code) {
  outbox_.clear();
  write_failure_ = code;
  error_code ignored;
  socket_.shutdown(tcp::socket::shutdown_both, ignored);
}

std::string TcpStream::reasonOf(const error_code& read_failure) const {
  if (write_failure_) {
    return write_failure_.message();
  }
  return read_failure == asio::error::eof ? "closed by the peer" : read_failure.message();
}

void TcpStream::close() {
  error_code ignored;
  socket_.close(ignored);
  outbox_.clear();
}

void TcpStream::end(const std::string& reason) {
  if (socket_.is_open()) {
    close();
    callbacks_.closed(reason);
  }
}

}  // namespace cobot_command::transport
