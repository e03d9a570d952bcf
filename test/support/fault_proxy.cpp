#include "fault_proxy.h"

#include <algorithm>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "proxy_session.h"
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>

namespace cobot_command::testing {
namespace asio = boost::asio;
using boost::asio::ip::tcp;
using boost::system::error_code;

namespace {

tcp::endpoint onLoopback(int port) {
  return {asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)};
}

/// A port that is kept, whether or not anybody listens on it; throws when it cannot be had.
void take(tcp::acceptor& acceptor, const tcp::endpoint& endpoint) {
  acceptor.open(endpoint.protocol());
  acceptor.set_option(tcp::acceptor::reuse_address(true));
  acceptor.bind(endpoint);
}

/// One port: its listener, its faults, its connections.
class Lane {
 public:
  Lane(asio::io_context& context, int controller, int listen, unsigned seed)
      : context_(context), controller_(onLoopback(controller)), faults_(seed), reservation_(context) {
    take(reservation_, onLoopback(listen));
    endpoint_ = reservation_.local_endpoint();
    open();
  }

  [[nodiscard]] int port() const { return endpoint_.port(); }
  [[nodiscard]] std::size_t strikes() const { return faults_.strikes(); }
  [[nodiscard]] std::size_t connections() {
    forgetEnded();
    return sessions_.size();
  }

  void add(const Fault& fault) {
    faults_.add(fault);
    if (fault.kind == FaultKind::Refuse) shut();
  }
  void heal() {
    faults_.clear();
    if (!listener_) open();
    for (const auto& session : std::vector(sessions_)) {
      session->closeIfItLeadsNowhere();
      session->resume();
    }
  }
  void reset() {
    for (const auto& session : std::exchange(sessions_, {})) {
      if (!session->ended()) session->reset();
    }
  }
  void end() {
    shut();
    reset();
    error_code ignored;
    reservation_.close(ignored);
  }

 private:
  void open() {
    listener_ = std::make_shared<tcp::acceptor>(context_);
    take(*listener_, endpoint_);
    listener_->listen();
    accept();
  }
  void shut() {
    if (!listener_) return;
    error_code ignored;
    listener_->close(ignored);
    listener_.reset();
  }
  void accept() {
    listener_->async_accept([this, listener = listener_](error_code code, tcp::socket socket) {
      if (code || listener != listener_) return;
      accept();
      welcome(std::move(socket));
    });
  }
  void welcome(tcp::socket socket) {
    if (faults_.has(FaultKind::CloseAtOnce)) return;  // closed with the socket
    forgetEnded();
    const auto session = std::make_shared<ProxySession>(context_, std::move(socket), faults_);
    sessions_.push_back(session);
    if (faults_.has(FaultKind::Silence)) {
      session->leadNowhere();
    } else {
      session->passOnTo(controller_);
    }
  }
  void forgetEnded() {
    sessions_.erase(
        std::remove_if(sessions_.begin(), sessions_.end(), [](const auto& s) { return s->ended(); }),
        sessions_.end());
  }

  asio::io_context& context_;
  const tcp::endpoint controller_;
  FrameFaults faults_;
  tcp::acceptor reservation_;
  tcp::endpoint endpoint_;
  std::shared_ptr<tcp::acceptor> listener_;  ///< unless refused
  std::vector<std::shared_ptr<ProxySession>> sessions_;
};

}  // namespace

class FaultProxy::Impl {
 public:
  Impl(ProxyPorts controller, unsigned seed, ProxyPorts listen)
      : work_(context_.get_executor()),
        script_(context_, controller.script, listen.script, seed),
        status_(context_, controller.status, listen.status, seed + 1),
        thread_([this] { context_.run(); }) {}
  ~Impl() {
    run([this] {
      script_.end();
      status_.end();
    });
    context_.stop();
    thread_.join();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// On the thread of the proxy; returns when it is done.
  template <class Task>
  void run(Task task) {
    const auto done = std::make_shared<std::promise<void>>();
    asio::post(context_, [&task, done] {
      task();
      done->set_value();
    });
    done->get_future().wait();
  }
  Lane& lane(Port port) { return port == Port::Script ? script_ : status_; }

 private:
  asio::io_context context_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  Lane script_;
  Lane status_;
  std::thread thread_;
};

FaultProxy::FaultProxy(ProxyPorts controller, unsigned seed, ProxyPorts listen)
    : impl_(std::make_unique<Impl>(controller, seed, listen)) {}

FaultProxy::~FaultProxy() = default;

ProxyPorts FaultProxy::ports() const {
  return {impl_->lane(Port::Script).port(), impl_->lane(Port::Status).port()};
}

void FaultProxy::add(Port port, const Fault& fault) {
  impl_->run([&] { impl_->lane(port).add(fault); });
}

void FaultProxy::heal() {
  impl_->run([&] {
    for (const Port port : {Port::Script, Port::Status}) impl_->lane(port).heal();
  });
}

void FaultProxy::reset() {
  impl_->run([&] {
    for (const Port port : {Port::Script, Port::Status}) impl_->lane(port).reset();
  });
}

std::size_t FaultProxy::strikes() const {
  std::size_t strikes = 0;
  impl_->run([&] { strikes = impl_->lane(Port::Script).strikes() + impl_->lane(Port::Status).strikes(); });
  return strikes;
}

std::size_t FaultProxy::connections() const {
  std::size_t count = 0;
  impl_->run(
      [&] { count = impl_->lane(Port::Script).connections() + impl_->lane(Port::Status).connections(); });
  return count;
}

}  // namespace cobot_command::testing
