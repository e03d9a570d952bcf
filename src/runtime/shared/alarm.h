// The timer of a core's thread, for deadlines that move with almost every event.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

namespace cobot_command::runtime {

/// Rings in time for the deadline, and now and then too early: most deadlines only move away before they are
/// over, a watchdog's with every frame, and to set a timer anew costs a call of the system and another round
/// of the loop. So it stays set for an earlier one. Whoever hears it looks whether anything is due, and sets
/// it again. For the thread of the context only.
class Alarm {
 public:
  using Clock = std::chrono::steady_clock;

  Alarm(boost::asio::io_context& context, std::function<void()> ring)
      : timer_(context), ring_(std::move(ring)) {}

  void setFor(Clock::time_point deadline) {
    if (set_for_ && *set_for_ <= deadline) return;
    set_for_ = deadline;
    timer_.expires_at(deadline);
    timer_.async_wait([this](const boost::system::error_code& replaced) {
      if (replaced) return;
      set_for_.reset();
      ring_();
    });
  }

 private:
  boost::asio::steady_timer timer_;
  const std::function<void()> ring_;
  std::optional<Clock::time_point> set_for_;
};

}  // namespace cobot_command::runtime
