#include "cobot_command/transport/tcp_connection.h"

#include <optional>
#include <utility>

#include "name_lookup.h"
#include "system_error.h"
#include "tcp_stream.h"
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

namespace cobot_command::transport {
namespace asio = boost::asio;
using boost::asio::ip::tcp;
using boost::system::error_code;

class TcpConnection::Impl : public std::enable_shared_from_this<Impl> {
 public:
  Impl(asio::io_context& context, Callbacks callbacks, std::size_t send_limit)
      : context_(context),
        callbacks_(std::move(callbacks)),
        send_limit_(send_limit),
        socket_(context),
        deadline_(context) {}

  void open(const std::string& host, std::uint16_t port, Duration timeout) {
    opening_ = true;
    deadline_.expires_after(timeout);
    deadline_.async_wait([self = shared_from_this()](error_code cancelled) {
      if (!cancelled) {
        self->fail(asio::error::timed_out);
      }
    });
    lookup_.emplace(context_, host, port, [this](const error_code& code, const auto& endpoints) {
      code ? fail(code) : connect(endpoints);
    });
  }

  void close() {
    endOpening();
    if (stream_) {
      stream_->close();
      stream_.reset();
    }
  }

  void send(std::string_view bytes) {
    if (stream_) {
      stream_->send(bytes);
    }
  }

  [[nodiscard]] bool isOpen() const { return stream_ != nullptr; }

 private:
  void connect(const NameLookup::Endpoints& endpoints) {
    asio::async_connect(socket_, endpoints,
                        [self = shared_from_this()](error_code code, const tcp::endpoint&) {
                          code ? self->fail(code) : self->connected();
                        });
  }

  void connected() {
    if (!opening_) {
      return;
    }
    if (isConnectedToItself()) {
      fail(asio::error::connection_refused);
      return;
    }
    tcp::socket socket = std::move(socket_);
    endOpening();
    stream_ = std::make_shared<TcpStream>(
        std::move(socket), send_limit_,
        TcpStream::Callbacks{[self = weak_from_this()](std::string_view bytes) {
                               if (const auto impl = self.lock()) {
                                 impl->callbacks_.received(bytes);
                               }
                             },
                             [self = weak_from_this()](const std::string& reason) {
                               if (const auto impl = self.lock()) {
                                 impl->stream_.reset();
                                 impl->callbacks_.closed(reason);
                               }
                             }});
    stream_->start();
    callbacks_.opened();
  }

  /// On one machine, a try on a free port may be given that very port as its own and so meet itself (TCP
  /// simultaneous open): nobody listens there, and the port would be blocked for its owner.
  [[nodiscard]] bool isConnectedToItself() const {
    error_code ignored;
    return socket_.local_endpoint(ignored) == socket_.remote_endpoint(ignored);
  }

  void fail(const error_code& code) {
    if (opening_) {
      const auto self = shared_from_this();
      endOpening();
      callbacks_.failed(toNetworkError(code));
    }
  }

  void endOpening() {
    opening_ = false;
    error_code ignored;
    deadline_.cancel(ignored);  // the form without it may throw, and this runs in destructors, too
    socket_.close(ignored);
    lookup_.reset();
  }

  asio::io_context& context_;
  const Callbacks callbacks_;
  const std::size_t send_limit_;
  bool opening_ = false;
  std::optional<NameLookup> lookup_;
  tcp::socket socket_;  ///< while opening
  asio::steady_timer deadline_;
  std::shared_ptr<TcpStream> stream_;  ///< once open
};

TcpConnection::TcpConnection(asio::io_context& context, Callbacks callbacks, std::size_t send_limit)
    : impl_(std::make_shared<Impl>(context, std::move(callbacks), send_limit)) {}

TcpConnection::~TcpConnection() {
  close();
}

void TcpConnection::open(const std::string& host, std::uint16_t port, Duration timeout) {
  impl_->open(host, port, timeout);
}
void TcpConnection::send(std::string_view bytes) {
  impl_->send(bytes);
}
void TcpConnection::close() {
  impl_->close();
}
bool TcpConnection::isOpen() const {
  return impl_->isOpen();
}

}  // namespace cobot_command::transport
