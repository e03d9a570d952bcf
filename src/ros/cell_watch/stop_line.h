// The line to the `stop` action of a robot's command node, or of a mechanism's seat, with what its log tells
// of the answers.
#pragma once

#include <cstdint>
#include <string>

#include "shared/stop_goals.h"
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "cobot_command/StopActionResult.h"
#include "cobot_command/ros/shared/own_handle.h"

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
  [[nodiscard]] bool isConnected() const { return goals_.isConnected(); }
  /// Nothing is heard any more.
  void end() { results_.shutdown(); }

 private:
  void hear(const cobot_command::StopActionResult& message) const;

  OwnHandle node_;
  std::string robot_;
  std::string id_;  ///< in front of those of its goals
  std::uint64_t sent_ = 0;
  StopGoals goals_;
  ros::Subscriber results_;
};

}  // namespace cobot_command::ros_adapter
