// A callback queue with a thread of its own, for callbacks that must not wait for others, or that may delay
// others.
#pragma once

#include <thread>

#include <ros/callback_queue.h>

#include "cobot_command/ros/shared/receipts.h"

namespace cobot_command::ros_adapter {

/// The AsyncSpinner of roscpp wakes up ten times per second, even without messages; this thread sleeps until
/// one arrives.
class ServingThread {
 public:
  /// `receipts`: of the node; must outlive this object.
  explicit ServingThread(Receipts& receipts) : numbered_(queue_, receipts) {}
  ~ServingThread();  ///< stop()
  ServingThread(const ServingThread&) = delete;
  ServingThread& operator=(const ServingThread&) = delete;

  /// For the node handles whose callbacks must run here. They must be destroyed before this object.
  [[nodiscard]] NumberedQueue& queue() { return numbered_; }

  /// From now on callbacks run, beginning with those that arrived before.
  void start();

  /// Waits until all callbacks that are in the queue now have run; after stop() there are none. Must not be
  /// called by one of its callbacks.
  void catchUp();

  /// Waits for the running callback. After it returns no callback runs, and new ones are dropped. Must not be
  /// called by one of its callbacks.
  void stop();

 private:
  void serve();

  ros::CallbackQueue queue_;
  NumberedQueue numbered_;
  std::thread thread_;
};

}  // namespace cobot_command::ros_adapter
