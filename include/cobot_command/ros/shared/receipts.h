// The order in which a node received its messages, independent of the queues and threads of their callbacks.
//
// roscpp reads all sockets on one thread, and puts the callback of each message into the queue of its
// subscriber at once. The callbacks may run in another order. Here each callback gets a number when it is put
// into its queue. So a goal that was received before a stop is recognized, although its callback runs later.
#pragma once

#include <atomic>
#include <cstdint>

#include <ros/callback_queue_interface.h>

namespace cobot_command::ros_adapter {

/// Increases from 1; 0: nothing was received yet.
using Receipt = std::uint64_t;

/// The counter for all queues of a node. Thread-safe.
class Receipts {
 public:
  [[nodiscard]] Receipt next() { return ++last_; }
  [[nodiscard]] Receipt last() const { return last_; }

 private:
  std::atomic<Receipt> last_{0};
};

/// Receipt of the callback that this thread is running. Precondition: the callback was in a NumberedQueue.
[[nodiscard]] Receipt currentReceipt();

/// Numbers the callbacks that are put into a queue. Thread-safe, like the queue.
class NumberedQueue : public ros::CallbackQueueInterface {
 public:
  /// Both must outlive this object, and `receipts` must outlive the callbacks.
  NumberedQueue(ros::CallbackQueueInterface& queue, Receipts& receipts)
      : queue_(queue), receipts_(receipts) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override;
  void removeByID(std::uint64_t owner) override { queue_.removeByID(owner); }

 private:
  ros::CallbackQueueInterface& queue_;
  Receipts& receipts_;
};

}  // namespace cobot_command::ros_adapter
