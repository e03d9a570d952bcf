#include "peer_server.h"

#include <condition_variable>
#include <future>
#include <map>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "event_log.h"
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "cobot_command/protocol/frame_decoder.h"
#include "cobot_command/transport/tcp_server.h"

namespace cobot_command::testing {
namespace asio = boost::asio;

class PeerServer::Impl {
 public:
  explicit Impl(MisbehavingPeer peer)
      : work_(context_.get_executor()),
        peer_(std::move(peer)),
        timer_(context_),
        server_(std::make_unique<transport::TcpServer>(
            context_, transport::TcpServer::Callbacks{
                          [this](transport::ClientId id) { connected(id); },
                          [this](transport::ClientId id, std::string_view bytes) { received(id, bytes); },
                          [this](transport::ClientId id, const std::string&) { clients_.erase(id); }})) {
    const auto port = server_->bind("127.0.0.1", 0);
    if (!port || !server_->open()) throw std::runtime_error("no port for a peer");
    port_ = *port;
    thread_ = std::thread([this] { context_.run(); });
    asio::post(context_, [this] { tick(); });
  }
  ~Impl() {
    context_.stop();
    thread_.join();
    server_.reset();
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[nodiscard]] int port() const { return port_; }

  void become(MisbehavingPeer peer) {
    const auto done = std::make_shared<std::promise<void>>();
    asio::post(context_, [this, done, peer = std::move(peer)]() mutable {
      peer_ = std::move(peer);
      server_->close();
      clients_.clear();
      (void)server_->open();
      done->set_value();
    });
    done->get_future().wait();
  }

  [[nodiscard]] bool hasSpoken() {
    std::unique_lock<std::mutex> lock(mutex_);
    return spoke_.wait_for(lock, kDeadline, [&] { return has_spoken_; });
  }

 private:
  struct Client {
    protocol::FrameDecoder decoder;
    int ticks = 0;
  };

  void connected(transport::ClientId id) {
    clients_[id];
    say(id, peer_.greets());
    const std::lock_guard<std::mutex> lock(mutex_);
    has_spoken_ = true;
    spoke_.notify_all();
  }

  void received(transport::ClientId id, std::string_view bytes) {
    Client& client = clients_[id];
    client.decoder.feed(bytes);
    while (const auto event = client.decoder.next()) {
      const auto* const frame = std::get_if<protocol::Frame>(&*event);
      const auto message = frame == nullptr ? std::nullopt : parsed(*frame);
      if (message) say(id, peer_.answers(*message));
      if (clients_.count(id) == 0) return;
    }
  }
  static std::optional<protocol::ClientMessage> parsed(const protocol::Frame& frame) {
    const auto message = protocol::parseClientMessage(frame);
    return message ? std::make_optional(*message) : std::nullopt;
  }

  /// A peer that floods does not fill the memory of the test: it waits for who reads slowly.
  void tick() {
    constexpr std::size_t kBacklog = std::size_t{256} * 1024;
    std::map<transport::ClientId, PeerTalk> talks;
    for (auto& [id, client] : clients_) {
      if (server_->backlog() < kBacklog) talks[id] = peer_.talks(++client.ticks);
    }
    for (const auto& [id, talk] : talks) say(id, talk);
    timer_.expires_after(kPeerTick);
    timer_.async_wait([this](const boost::system::error_code& cancelled) {
      if (!cancelled) tick();
    });
  }

  void say(transport::ClientId id, const PeerTalk& talk) {
    if (!talk.bytes.empty()) server_->send(id, talk.bytes);
    if (!talk.closes) return;
    server_->closeClient(id);
    clients_.erase(id);
  }

  asio::io_context context_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  MisbehavingPeer peer_;
  asio::steady_timer timer_;
  std::map<transport::ClientId, Client> clients_;
  std::unique_ptr<transport::TcpServer> server_;
  int port_ = 0;
  std::mutex mutex_;
  std::condition_variable spoke_;
  bool has_spoken_ = false;
  std::thread thread_;
};

PeerServer::PeerServer(MisbehavingPeer peer) : impl_(std::make_unique<Impl>(std::move(peer))) {}

PeerServer::~PeerServer() = default;

int PeerServer::port() const {
  return impl_->port();
}
void PeerServer::become(MisbehavingPeer peer) {
  impl_->become(std::move(peer));
}
bool PeerServer::hasSpoken() const {
  return impl_->hasSpoken();
}

}  // namespace cobot_command::testing
