// A callback queue that a thread of its own serves, for what must not wait for other callbacks, or may keep
// others waiting.
#pragma once

#include <thread>

#include <ros/callback_queue.h>

#include "cobot_command/ros/shared/receipts.h"

namespace cobot_command::ros_adapter {

/// roscpp's AsyncSpinner wakes up ten times a second, also when nothing comes; this one sleeps until
/// something does.
class ServingThread {
 public:
  /// `receipts`: of the node; have to live longer.
  explicit ServingThread(Receipts& receipts) : numbered_(queue_, receipts) {}
  ~ServingThread();  ///< stop()
  ServingThread(const ServingThread&) = delete;
  ServingThread& operator=(const ServingThread&) = delete;

  /// For the node handles whose callbacks are to run here. They have to be gone before this is.
  [[nodiscard]] NumberedQueue& queue() { return numbered_; }

  /// From here on callbacks run; those that came before it first.
  void start();

  /// Waits until every callback has run that is in the queue by now; after stop() there is none. Not from one
  /// of its callbacks.
  void catchUp();

  /// Waits for the callback that runs. No callback runs any more when it returns; what comes is dropped. Not
  /// from one of its callbacks.
  void stop();

 private:
  void serve();

  ros::CallbackQueue queue_;
  NumberedQueue numbered_;
  std::thread thread_;
};

}  // namespace cobot_command::ros_adapter
