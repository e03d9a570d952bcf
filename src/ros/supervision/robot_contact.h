// One robot's command node, as the supervisor finds it: by who sends its reports. Stops it, and has its
// program run.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "shared/made_beside.h"
#include "shared/stop_goals.h"
#include <actionlib/client/action_client.h>
#include <ros/node_handle.h>

#include "cobot_command/RunProgramAction.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

class RobotContact {
 public:
  using ProgramClient = actionlib::ActionClient<cobot_command::RunProgramAction>;
  using ProgramHandle = ProgramClient::GoalHandle;

  explicit RobotContact(const ros::NodeHandle& node) : node_(node), stops_(node) {}

  /// A report of it came from that node ("/RA/command_node"), whose actions are in its namespace. Waits for
  /// nothing: it can be reached as soon as the master has answered.
  void heardFrom(const std::string& publisher, bool moving, Instant now);
  [[nodiscard]] const std::string& publisher() const { return publisher_; }

  /// It is told until it stands, as a message to a node that just came up can be lost. Where it does not
  /// move, and nobody listens within 5 s, that is given up, and logged.
  void stop(Instant now);
  /// Tells it again, if it has to.
  void settle(Instant now);

  /// nullptr: its node was not heard yet, or does not answer; or some client is just being made.
  [[nodiscard]] std::shared_ptr<ProgramClient> programs() const;

 private:
  ros::NodeHandle node_;
  std::string publisher_;
  StopGoals stops_;
  std::string space_;  ///< of its node
  /// By namespace, all until the end: see StopGoals.
  std::map<std::string, MadeBeside<ProgramClient>> programs_;
  bool is_stopping_ = false;
  bool moves_ = false;  ///< by its last report
  Instant ordered_at_;
  std::optional<Instant> stop_told_;
};

}  // namespace cobot_command::ros_adapter
