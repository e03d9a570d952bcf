// Publishes that a jog button is held, on a thread of its own: a user interface that is busy drawing for a
// moment does not end the motion, and one that hangs does.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "clients/grip.h"

namespace cobot_command::rviz_plugin {

class KeepAlive {
 public:
  /// `publish` is called on the other thread, every 20 ms while the button is held.
  explicit KeepAlive(std::function<void()> publish);
  KeepAlive(const KeepAlive&) = delete;
  KeepAlive& operator=(const KeepAlive&) = delete;
  ~KeepAlive();

  void begin();
  /// The thread of the user interface lives: without this for 100 ms nothing is published.
  void tick();
  /// Nothing is published any more once this has returned.
  void end();

 private:
  void serve();

  std::function<void()> publish_;
  std::mutex mutex_;
  std::condition_variable changed_;
  Grip grip_;
  bool ends_ = false;
  std::thread thread_;  ///< last: it uses all of these
};

}  // namespace cobot_command::rviz_plugin
