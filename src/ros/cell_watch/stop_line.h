// The line to the `stop` action of a robot's command node. A goal is on its way as soon as it is published:
// no robot waits for another one, nor for its answer.
#pragma once

#include <cstdint>
#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>

#include "cobot_command/StopActionResult.h"

namespace cobot_command::ros_adapter {

class StopLine {
 public:
  /// Answers come by the callback queue of `node`.
  StopLine(const ros::NodeHandle& node, std::string robot, const std::string& space);
  StopLine(const StopLine&) = delete;
  StopLine& operator=(const StopLine&) = delete;

  /// From now on the robot's node is in that namespace.
  void moveTo(const std::string& space);
  /// Where nobody is at the other end, an error in the log.
  void stop();
  [[nodiscard]] bool isConnected() const { return goals_.getNumSubscribers() > 0; }
  /// Nothing is heard any more.
  void end() { results_.shutdown(); }

 private:
  void hear(const cobot_command::StopActionResult& message) const;

  ros::NodeHandle node_;
  std::string robot_;
  std::string space_;
  std::string id_;  ///< in front of those of its goals
  std::uint64_t sent_ = 0;
  ros::Publisher goals_;
  ros::Subscriber results_;
};

}  // namespace cobot_command::ros_adapter
