// The line to the `stop` action of a robot's command node, or of a mechanism's seat, with what its log tells
// of the answers.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "shared/made_beside.h"
#include "shared/stop_goals.h"
#include <ros/callback_queue_interface.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "cobot_command/StopActionResult.h"
#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

class StopLine {
 public:
  /// Answers come by `queue`, which is that of `node`. Waits for the master.
  StopLine(const ros::NodeHandle& node, std::shared_ptr<ros::CallbackQueueInterface> queue, std::string robot,
           const std::string& space);
  StopLine(const StopLine&) = delete;
  StopLine& operator=(const StopLine&) = delete;

  /// The robot's node is in that namespace, and can be told to stop as soon as the master has answered.
  void moveTo(const std::string& space);
  /// Where nobody is at the other end, an error in the log.
  void stop();
  [[nodiscard]] bool isConnected() const { return goals_.isConnected(); }
  /// Nothing is heard any more.
  void end() { results_.drop(); }

 private:
  [[nodiscard]] MadeBeside<ros::Subscriber>::Make listeningIn(const std::string& space) const;

  OwnHandle node_;
  std::shared_ptr<ros::CallbackQueueInterface> queue_;
  std::string robot_;
  std::string id_;  ///< in front of those of its goals
  std::uint64_t sent_ = 0;
  StopGoals goals_;
  MadeBeside<ros::Subscriber> results_;
};

}  // namespace cobot_command::ros_adapter
