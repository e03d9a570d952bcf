// Messages between robots and the supervisor, some of them late, lost or doubled: each is late by itself, so
// that old ones come behind new ones.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/report.h"
#include "cobot_command/trial/cell_trial.h"

namespace cobot_command::trial {

class CellTrial::Mail {
 public:
  struct Told {
    cell::RobotIndex robot = 0;
    std::shared_ptr<const cell::CellStatus> state;
    std::uint64_t number = 0;
  };

  Mail(std::uint64_t seed, Duration delay, double loss, double doubled)
      : random_(seed), delay_(delay), loss_(loss), doubled_(doubled) {}

  void send(const cell::RobotReport& report, Instant now) { send(report, reports_, now); }
  void send(const Told& told, Instant now) { send(told, states_, now); }
  [[nodiscard]] std::vector<cell::RobotReport> takeReports(Instant now) { return take(reports_, now); }
  [[nodiscard]] std::vector<Told> takeStates(Instant now) { return take(states_, now); }
  [[nodiscard]] Instant next() const {
    Instant next = Instant::max();
    if (!reports_.empty()) next = reports_.begin()->first;
    if (!states_.empty()) next = std::min(next, states_.begin()->first);
    return next;
  }

  /// [0, 1)
  [[nodiscard]] double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }

 private:
  template <class Message>
  void send(const Message& message, std::multimap<Instant, Message>& messages, Instant now) {
    if (loss_ > 0.0 && share() < loss_) return;
    messages.emplace(arrival(now), message);
    if (doubled_ > 0.0 && share() < doubled_) messages.emplace(arrival(now), message);
  }

  [[nodiscard]] Instant arrival(Instant now) {
    return delay_ > Duration::zero() ? now + fromSeconds(share() * toSeconds(delay_)) : now;
  }

  template <class Message>
  [[nodiscard]] static std::vector<Message> take(std::multimap<Instant, Message>& messages, Instant now) {
    std::vector<Message> taken;
    const auto end = messages.upper_bound(now);
    for (auto message = messages.begin(); message != end; ++message) {
      taken.push_back(std::move(message->second));
    }
    messages.erase(messages.begin(), end);
    return taken;
  }

  std::mt19937_64 random_;
  Duration delay_;
  double loss_;
  double doubled_;
  std::multimap<Instant, cell::RobotReport> reports_;
  std::multimap<Instant, Told> states_;
};

}  // namespace cobot_command::trial
