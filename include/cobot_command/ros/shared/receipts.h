// The order in which a node received its messages, whatever queue and thread their callbacks wait in.
//
// roscpp reads all sockets on one thread, and puts the callback of each message into the queue of its
// subscriber at once; which callback runs first is another matter. Here each callback gets a number when it
// is put into its queue, so that a goal that was received before a stop is known as that, though its callback
// runs later.
#pragma once

#include <atomic>
#include <cstdint>

#include <ros/callback_queue_interface.h>

namespace cobot_command::ros_adapter {

/// Counts up from 1; 0: nothing was received yet.
using Receipt = std::uint64_t;

/// Counts for all queues of a node. Thread-safe.
class Receipts {
 public:
  [[nodiscard]] Receipt next() { return ++last_; }
  [[nodiscard]] Receipt last() const { return last_; }

 private:
  std::atomic<Receipt> last_{0};
};

/// Of the callback that this thread is in. Precondition: it came through a NumberedQueue.
[[nodiscard]] Receipt currentReceipt();

/// Numbers what goes into a queue. Thread-safe, as the queue is.
class NumberedQueue : public ros::CallbackQueueInterface {
 public:
  /// Both have to live longer than it, and `receipts` longer than the callbacks.
  NumberedQueue(ros::CallbackQueueInterface& queue, Receipts& receipts)
      : queue_(queue), receipts_(receipts) {}

  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) override;
  void removeByID(std::uint64_t owner) override { queue_.removeByID(owner); }

 private:
  ros::CallbackQueueInterface& queue_;
  Receipts& receipts_;
};

}  // namespace cobot_command::ros_adapter
