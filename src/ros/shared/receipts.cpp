#include "cobot_command/ros/shared/receipts.h"

#include <cassert>
#include <utility>

#include <boost/make_shared.hpp>

namespace cobot_command::ros_adapter {
namespace {

thread_local Receipt current = 0;

class Numbered : public ros::CallbackInterface {
 public:
  Numbered(ros::CallbackInterfacePtr callback, Receipt receipt)
      : callback_(std::move(callback)), receipt_(receipt) {}

  /// One that waits for messages within its own may be in the middle of another.
  CallResult call() override {
    const Receipt outer = std::exchange(current, receipt_);
    const CallResult result = callback_->call();
    current = outer;
    return result;
  }
  bool ready() override { return callback_->ready(); }

 private:
  const ros::CallbackInterfacePtr callback_;
  const Receipt receipt_;
};

}  // namespace

Receipt currentReceipt() {
  assert(current != 0);
  return current;
}

void NumberedQueue::addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t owner) {
  queue_.addCallback(boost::make_shared<Numbered>(callback, receipts_.next()), owner);
}

}  // namespace cobot_command::ros_adapter
