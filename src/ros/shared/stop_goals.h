// Goals of the action `stop` to one node: that of a robot, or the seat of a mechanism. A goal is on its way
// as soon as it is published: nobody waits for another one, nor for an answer.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "shared/made_beside.h"
#include <ros/node_handle.h>
#include <ros/publisher.h>

namespace cobot_command::ros_adapter {

class StopGoals {
 public:
  explicit StopGoals(const ros::NodeHandle& node) : node_(node) {}

  /// From now on they go to the node in that namespace, "/RA"; before that to nobody. Waits for the master.
  void beginAt(const std::string& space);
  /// The same, from when the master has answered on; until then they go to nobody.
  void moveTo(const std::string& space);
  /// `id`: of the goal, by which its answer is known; empty: whoever takes it gives it one.
  void send(const std::string& id = "");
  /// Whether somebody is at the other end.
  [[nodiscard]] bool isConnected() const;
  [[nodiscard]] const std::string& topic() const { return topic_; }

 private:
  [[nodiscard]] std::shared_ptr<ros::Publisher> goals() const;

  ros::NodeHandle node_;
  std::string topic_;
  /// By topic, all until the end: while one of them is destroyed, no other can publish until the master has
  /// answered.
  std::map<std::string, MadeBeside<ros::Publisher>> goals_;
};

}  // namespace cobot_command::ros_adapter
