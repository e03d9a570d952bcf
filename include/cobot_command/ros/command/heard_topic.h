// A topic that knows whether anybody listens to it.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include <ros/publisher.h>

#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

/// To ask roscpp, as ros::Publisher does, takes a search through all topics of the node under a lock: some
/// eighty, and the question comes with every status frame. roscpp tells who comes and goes on its spinner.
class HeardTopic {
 public:
  HeardTopic() = default;
  template <class Message>
  static HeardTopic advertise(OwnHandle& node, const std::string& name, std::uint32_t queue_size,
                              bool latch = false) {
    HeardTopic topic;
    topic.publisher_ = node.advertise<Message>(
        name, queue_size, [listeners = topic.listeners_](const auto&) { ++*listeners; },
        [listeners = topic.listeners_](const auto&) { --*listeners; }, ros::VoidConstPtr(), latch);
    return topic;
  }

  [[nodiscard]] bool isHeard() const { return *listeners_ > 0; }
  template <class Message>
  void publish(const Message& message) const {
    publisher_.publish(message);
  }

 private:
  ros::Publisher publisher_;
  std::shared_ptr<std::atomic<int>> listeners_ = std::make_shared<std::atomic<int>>(0);
};

}  // namespace cobot_command::ros_adapter
