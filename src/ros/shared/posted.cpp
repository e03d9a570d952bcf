#include "cobot_command/ros/shared/posted.h"

#include <utility>

#include <boost/make_shared.hpp>

namespace cobot_command::ros_adapter {
namespace {

struct Posted : ros::CallbackInterface {
  explicit Posted(std::function<void()> what) : what_(std::move(what)) {}
  CallResult call() override {
    what_();
    return Success;
  }
  const std::function<void()> what_;
};

}  // namespace

void post(ros::CallbackQueueInterface& queue, std::function<void()> what, const void* owner) {
  queue.addCallback(boost::make_shared<Posted>(std::move(what)), ownerOf(owner));
}

}  // namespace cobot_command::ros_adapter
