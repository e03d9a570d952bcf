#include "proxy_session.h"

#include <utility>
#include <variant>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/write.hpp>

namespace cobot_command::testing {
namespace asio = boost::asio;
using boost::asio::ip::tcp;
using boost::system::error_code;

ProxySession::ProxySession(asio::io_context& context, Socket client, FrameFaults& faults)
    : context_(context),
      faults_(faults),
      client_(std::move(client)),
      controller_(context),
      to_controller_(context, Direction::ToController),
      to_client_(context, Direction::ToClient) {
  error_code ignored;
  client_.set_option(tcp::no_delay(true), ignored);
}

void ProxySession::passOnTo(const tcp::endpoint& controller) {
  controller_.async_connect(controller, [self = shared_from_this()](error_code code) {
    if (self->ended_) return;
    if (code) {
      self->reset();
      return;
    }
    error_code ignored;
    self->controller_.set_option(tcp::no_delay(true), ignored);
    self->read(self->to_controller_);
    self->read(self->to_client_);
  });
}

void ProxySession::leadNowhere() {
  leads_nowhere_ = true;
  read(to_controller_);
}

void ProxySession::closeIfItLeadsNowhere() {
  if (leads_nowhere_) reset();
}

void ProxySession::resume() {
  for (Way* const w : {&to_controller_, &to_client_}) {
    if (std::exchange(w->left_unread, false)) received(*w, std::exchange(w->unread, 0));
  }
}

void ProxySession::reset() {
  error_code ignored;
  for (Socket* const socket : {&client_, &controller_}) {
    if (socket->is_open()) socket->set_option(tcp::socket::linger(true, 0), ignored);
  }
  end();
}

void ProxySession::end() {
  ended_ = true;
  error_code ignored;
  client_.close(ignored);
  controller_.close(ignored);
  for (Way* const w : {&to_controller_, &to_client_}) {
    w->timer.cancel(ignored);
    w->steps.clear();
  }
}

void ProxySession::read(Way& w) {
  source(w).async_read_some(asio::buffer(w.inbox),
                            [self = shared_from_this(), &w](error_code code, std::size_t size) {
                              if (self->ended_) return;
                              if (code) {
                                self->sourceEnded(w, code == asio::error::eof);
                              } else if (self->faults_.neverReads(w.direction)) {
                                w.left_unread = true;
                                w.unread = size;
                              } else {
                                self->received(w, size);
                              }
                            });
}

void ProxySession::received(Way& w, std::size_t size) {
  if (!leads_nowhere_ && !closing_) {
    w.cutter.feed(std::string_view(w.inbox.data(), size));
    while (const auto piece = w.cutter.next()) {
      if (const auto* const raw = std::get_if<std::string>(&*piece)) {
        add({Step::Kind::Send, w.direction, *raw, Duration{}});
        continue;
      }
      for (Step& step : faults_.pass(w.direction, std::get<protocol::Frame>(*piece))) add(std::move(step));
    }
  }
  if (!ended_) read(w);
}

/// A FIN goes on behind the bytes that came before it; a RST does not wait.
void ProxySession::sourceEnded(Way& w, bool orderly) {
  ++sources_ended_;
  if (!orderly) {
    reset();
  } else if (leads_nowhere_ || sources_ended_ == 2) {
    end();
  } else if (!closing_) {
    add({Step::Kind::Close, w.direction, "", Duration{}});
  }
}

void ProxySession::add(Step step) {
  if (ended_ || closing_) return;
  if (step.kind == Step::Kind::SendOvertaken) {
    sendLater(step);
    return;
  }
  Way& w = way(step.direction);
  w.steps.push_back({std::move(step), std::chrono::steady_clock::now()});
  run(w);
}

void ProxySession::sendLater(const Step& step) {
  const auto timer = std::make_shared<asio::steady_timer>(context_, step.wait);
  timer->async_wait([self = shared_from_this(), timer, step](error_code code) {
    if (!code) self->add({Step::Kind::Send, step.direction, step.bytes, Duration{}});
  });
}

void ProxySession::run(Way& w) {
  if (w.busy || w.steps.empty() || ended_) return;
  w.busy = true;
  const auto& [step, came] = w.steps.front();
  if (step.wait <= Duration::zero()) {
    perform(w);
    return;
  }
  const bool from_arrival = step.kind == Step::Kind::SendDelayed;
  w.timer.expires_at((from_arrival ? came : std::chrono::steady_clock::now()) + step.wait);
  w.timer.async_wait([self = shared_from_this(), &w](error_code) {
    if (self->ended_ || w.steps.empty()) {
      w.busy = false;  // close() has dropped what was to be done
      return;
    }
    self->perform(w);
  });
}

void ProxySession::perform(Way& w) {
  Step step = std::move(w.steps.front().step);
  w.steps.pop_front();
  if (step.kind == Step::Kind::Reset) {
    reset();
    return;
  }
  if (step.kind == Step::Kind::Close) {
    close();
    return;
  }
  w.outbox = std::move(step.bytes);
  if (step.kind == Step::Kind::SendMerged) {
    for (; !w.steps.empty() && w.steps.front().step.kind == Step::Kind::SendMerged; w.steps.pop_front()) {
      w.outbox += w.steps.front().step.bytes;
    }
  }
  write(w);
}

void ProxySession::write(Way& w) {
  asio::async_write(target(w), asio::buffer(w.outbox),
                    [self = shared_from_this(), &w](error_code code, std::size_t) {
                      w.busy = false;
                      if (self->ended_) return;
                      // A broken connection is told by its reader.
                      if (code) w.steps.clear();
                      self->run(w);
                    });
}

/// Nothing that waits is sent any more. The session lasts until both sides have closed, too.
void ProxySession::close() {
  closing_ = true;
  error_code ignored;
  client_.shutdown(tcp::socket::shutdown_send, ignored);
  controller_.shutdown(tcp::socket::shutdown_send, ignored);
  for (Way* const w : {&to_controller_, &to_client_}) w->steps.clear();
}

}  // namespace cobot_command::testing
