// What another thread reports, and a way to wait for it without sleeping.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>
#include <vector>

namespace cobot_command::testing {

/// Generous: reached only when something is broken.
inline constexpr auto kDeadline = std::chrono::seconds(60);

/// Thread-safe.
template <class Event>
class EventLog {
 public:
  void add(Event event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    events_.push_back(std::move(event));
    changed_.notify_all();
  }

  /// Waits until `condition(events)` is true; false when it does not become true in time.
  template <class Condition>
  [[nodiscard]] bool waitUntil(Condition condition) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, kDeadline, [&] { return condition(std::as_const(events_)); });
  }

  [[nodiscard]] std::vector<Event> events() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return events_;
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Event> events_;
};

}  // namespace cobot_command::testing
