#include "monitor/alarm.h"

#include <utility>

namespace cobot_command::cell::monitor {
namespace {

/// No arm, and no mechanism that it is meant for, takes longer than this to stop.
constexpr Duration kRepeat = std::chrono::milliseconds(500);

}  // namespace

void Alarm::warn(std::string text) {
  actions_.emplace_back(Warning{std::move(text)});
}

void Alarm::ended(Breach breach) {
  actions_.emplace_back(BreachEnded{std::move(breach)});
}

void Alarm::raise(const std::string& why, Instant now) {
  if (mode_ == MonitorSettings::Mode::Warn) {
    warn(why + " Nothing is stopped, because the monitor only warns.");
    return;
  }
  if (!why_) why_ = why;
  stopAll(why, now);
}

void Alarm::moving(Instant now) {
  if (!why_ || now - stopped_ < kRepeat) return;
  stopAll("Something moves although all must be at standstill until the monitor is reset. " + *why_, now);
}

void Alarm::stopAll(std::string why, Instant now) {
  stopped_ = now;
  actions_.emplace_back(StopAll{std::move(why)});
}

std::vector<MonitorAction> Alarm::takeActions() {
  return std::exchange(actions_, {});
}

}  // namespace cobot_command::cell::monitor
