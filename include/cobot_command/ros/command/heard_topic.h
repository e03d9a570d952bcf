// A topic that stores whether it has subscribers.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include <ros/publisher.h>

#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

/// ros::Publisher asks roscpp, which searches all topics of the node under a lock: about eighty topics, for
/// every status frame. Here roscpp reports each new and each lost subscriber, on its spinner.
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
