#include "cobot_command/ros/shared/serving_thread.h"

#include <future>
#include <memory>
#include <utility>

#include <ros/duration.h>

#include "cobot_command/ros/shared/posted.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr double kServePeriod = 3600;  // [s]; whatever comes, and the end, wakes the queue up

}  // namespace

ServingThread::~ServingThread() {
  stop();
}

void ServingThread::start() {
  thread_ = std::thread([this] { serve(); });
}

/// What is dropped breaks its promise, which ends the wait as well.
void ServingThread::catchUp() {
  if (queue_.isEmpty()) return;
  auto reached = std::make_shared<std::promise<void>>();
  auto waiting = reached->get_future();
  post(
      queue_, [reached = std::move(reached)] { reached->set_value(); }, this);
  waiting.wait();
}

/// A disabled queue wakes up who waits for it.
void ServingThread::stop() {
  queue_.disable();
  if (thread_.joinable()) thread_.join();
  queue_.clear();
}

void ServingThread::serve() {
  while (queue_.isEnabled()) queue_.callOne(ros::WallDuration(kServePeriod));
}

}  // namespace cobot_command::ros_adapter
