#include "clients/keep_alive.h"

#include <utility>

namespace cobot_command::rviz_plugin {
namespace {

constexpr std::chrono::milliseconds kPeriod(
    20);  // of the 250 ms that the watchdog of the command node allows

Grip::Time now() {
  return std::chrono::steady_clock::now();
}

}  // namespace

KeepAlive::KeepAlive(std::function<void()> publish)
    : publish_(std::move(publish)), thread_([this] { serve(); }) {}

KeepAlive::~KeepAlive() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    changed_.notify_all();
  }
  thread_.join();
}

void KeepAlive::begin() {
  const std::lock_guard lock(mutex_);
  grip_.take(now());
  changed_.notify_all();
}

void KeepAlive::tick() {
  const std::lock_guard lock(mutex_);
  grip_.tick(now());
}

void KeepAlive::end() {
  const std::lock_guard lock(mutex_);
  grip_.letGo();
}

void KeepAlive::serve() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ends_ || grip_.isTaken(); });
    if (ends_) return;
    // With the lock held, so that end() has the last word.
    if (grip_.holds(now())) publish_();
    changed_.wait_for(lock, kPeriod, [this] { return ends_; });
  }
}

}  // namespace cobot_command::rviz_plugin
