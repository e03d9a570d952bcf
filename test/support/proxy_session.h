// One connection through a fault proxy: two sockets, and what is under way between them in both directions.
//
// Belongs to the thread that runs the io_context. Pending operations keep it alive.
#pragma once

#include <array>
#include <chrono>
#include <deque>
#include <memory>
#include <string>

#include "frame_cutter.h"
#include "frame_faults.h"
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>

namespace cobot_command::testing {

class ProxySession : public std::enable_shared_from_this<ProxySession> {
 public:
  using Socket = boost::asio::ip::tcp::socket;

  /// The faults must outlive the io_context's run.
  ProxySession(boost::asio::io_context& context, Socket client, FrameFaults& faults);

  void passOnTo(const boost::asio::ip::tcp::endpoint& controller);
  /// Nobody is at the other end.
  void leadNowhere();

  void closeIfItLeadsNowhere();
  /// Reads on what a fault had left unread.
  void resume();
  /// RST on both sides.
  void reset();
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  struct Way {
    Way(boost::asio::io_context& context, Direction d) : direction(d), timer(context) {}

    const Direction direction;
    FrameCutter cutter;
    std::array<char, std::size_t{16} * 1024> inbox{};
    std::size_t unread = 0;  ///< bytes in the inbox that a fault leaves there
    bool left_unread = false;
    struct Waiting {
      Step step;
      std::chrono::steady_clock::time_point came;
    };
    std::deque<Waiting> steps;
    boost::asio::steady_timer timer;
    bool busy = false;  ///< with the first step
    std::string outbox;
  };

  [[nodiscard]] Way& way(Direction direction) {
    return direction == Direction::ToClient ? to_client_ : to_controller_;
  }
  [[nodiscard]] Socket& source(const Way& w) {
    return w.direction == Direction::ToClient ? controller_ : client_;
  }
  [[nodiscard]] Socket& target(const Way& w) {
    return w.direction == Direction::ToClient ? client_ : controller_;
  }

  void read(Way& w);
  void received(Way& w, std::size_t size);
  void sourceEnded(Way& w, bool orderly);
  void add(Step step);
  void sendLater(const Step& step);
  void run(Way& w);
  void perform(Way& w);
  void write(Way& w);
  void close();
  void end();

  boost::asio::io_context& context_;
  FrameFaults& faults_;
  Socket client_;
  Socket controller_;
  Way to_controller_;
  Way to_client_;
  bool leads_nowhere_ = false;
  bool closing_ = false;  ///< FIN was sent both ways, what still comes is dropped
  int sources_ended_ = 0;
  bool ended_ = false;
};

}  // namespace cobot_command::testing
