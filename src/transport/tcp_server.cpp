#include "cobot_command/transport/tcp_server.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <utility>

#include "system_error.h"
#include "tcp_stream.h"
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

namespace cobot_command::transport {
namespace asio = boost::asio;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

/// Before the next try when a client could not be accepted, for instance for want of descriptors.
constexpr auto kAcceptPause = std::chrono::milliseconds(100);

ClientId nextClientId() {
  static std::atomic<ClientId> last{0};
  return ++last;
}

/// A bound socket that does not listen: it refuses clients. SO_REUSEADDR lets a listener join it on its port,
/// and a new listener start while connections of an old one are still waiting out their end.
error_code bindTo(const tcp::endpoint& endpoint, tcp::acceptor& acceptor) {
  error_code code;
  acceptor.open(endpoint.protocol(), code);
  if (!code) {
    acceptor.set_option(tcp::acceptor::reuse_address(true), code);
  }
  if (!code) {
    acceptor.bind(endpoint, code);
  }
  return code;
}

}  // namespace

class TcpServer::Impl : public std::enable_shared_from_this<Impl> {
 public:
  Impl(asio::io_context& context, Callbacks callbacks, std::size_t send_limit)
      : context_(context),
        callbacks_(std::move(callbacks)),
        send_limit_(send_limit),
        reservation_(context),
        pause_(context) {}

  Result<std::uint16_t, NetworkError> bind(const std::string& address, std::uint16_t port) {
    error_code code;
    const auto ip = asio::ip::make_address(address, code);
    if (!code) {
      code = bindTo(tcp::endpoint(ip, port), reservation_);
    }
    if (!code) {
      endpoint_ = reservation_.local_endpoint(code);
    }
    if (code) {
      return refuse(toNetworkError(code));
    }
    return endpoint_.port();
  }

  Result<void, NetworkError> open() {
    if (listener_) {
      return {};
    }
    auto listener = std::make_shared<tcp::acceptor>(context_);
    auto code = bindTo(endpoint_, *listener);
    if (!code) {
      listener->listen(tcp::acceptor::max_listen_connections, code);
    }
    if (code) {
      return refuse(toNetworkError(code));
    }
    listener_ = std::move(listener);
    accept();
    return {};
  }

  void close() {
    error_code ignored;
    pause_.cancel(ignored);  // the form without it may throw, and this runs in the destructor, too
    if (listener_) {
      listener_->close(ignored);
      listener_.reset();
    }
    for (auto& [id, client] : std::exchange(clients_, {})) {
      client->close();
    }
  }

  void release() {
    close();
    error_code ignored;
    reservation_.close(ignored);
  }

  [[nodiscard]] bool isOpen() const { return listener_ != nullptr; }

  void send(ClientId id, std::string_view bytes) {
    if (const auto client = clients_.find(id); client != clients_.end()) {
      client->second->send(bytes);
    }
  }

  void closeClient(ClientId id) {
    if (const auto client = clients_.find(id); client != clients_.end()) {
      client->second->close();
      clients_.erase(client);
    }
  }

  [[nodiscard]] std::string addressOf(ClientId id) const {
    const auto client = clients_.find(id);
    return client == clients_.end() ? std::string() : client->second->peerAddress();
  }

  [[nodiscard]] std::size_t backlog() const {
    std::size_t worst = 0;
    for (const auto& [id, client] : clients_) {
      worst = std::max(worst, client->backlog());
    }
    return worst;
  }

 private:
  void accept() {
    listener_->async_accept(
        [self = shared_from_this(), listener = listener_](error_code code, tcp::socket socket) {
          if (self->listener_ != listener) {
            return;  // closed meanwhile
          }
          if (code) {
            self->acceptLater();
            return;
          }
          self->accept();
          self->welcome(std::move(socket));
        });
  }

  void acceptLater() {
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([self = shared_from_this(), listener = listener_](error_code cancelled) {
      if (!cancelled && self->listener_ == listener) {
        self->accept();
      }
    });
  }

  void welcome(tcp::socket socket) {
    const ClientId id = nextClientId();
    const auto client = std::make_shared<TcpStream>(
        std::move(socket), send_limit_,
        TcpStream::Callbacks{[self = weak_from_this(), id](std::string_view bytes) {
                               if (const auto impl = self.lock()) {
                                 impl->callbacks_.received(id, bytes);
                               }
                             },
                             [self = weak_from_this(), id](const std::string& reason) {
                               if (const auto impl = self.lock()) {
                                 impl->clients_.erase(id);
                                 impl->callbacks_.disconnected(id, reason);
                               }
                             }});
    clients_.emplace(id, client);
    client->start();
    callbacks_.connected(id);
  }

  asio::io_context& context_;
  const Callbacks callbacks_;
  const std::size_t send_limit_;
  /// Holds the port while the server is closed, so that the system gives it to nobody else.
  tcp::acceptor reservation_;
  tcp::endpoint endpoint_;
  std::shared_ptr<tcp::acceptor> listener_;  ///< only while open
  asio::steady_timer pause_;
  std::map<ClientId, std::shared_ptr<TcpStream>> clients_;
};

TcpServer::TcpServer(asio::io_context& context, Callbacks callbacks, std::size_t send_limit)
    : impl_(std::make_shared<Impl>(context, std::move(callbacks), send_limit)) {}

TcpServer::~TcpServer() {
  impl_->release();
}

Result<std::uint16_t, NetworkError> TcpServer::bind(const std::string& address, std::uint16_t port) {
  return impl_->bind(address, port);
}
Result<void, NetworkError> TcpServer::open() {
  return impl_->open();
}
void TcpServer::close() {
  impl_->close();
}
bool TcpServer::isOpen() const {
  return impl_->isOpen();
}
void TcpServer::send(ClientId client, std::string_view bytes) {
  impl_->send(client, bytes);
}
void TcpServer::closeClient(ClientId client) {
  impl_->closeClient(client);
}
std::string TcpServer::addressOf(ClientId client) const {
  return impl_->addressOf(client);
}
std::size_t TcpServer::backlog() const {
  return impl_->backlog();
}

}  // namespace cobot_command::transport
