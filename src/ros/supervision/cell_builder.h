// The action build_cell: a build on a thread of its own, one at a time.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include "cobot_command/BuildCellAction.h"
#include "cobot_command/cell/model/supervisors.h"
#include "cobot_command/ros/shared/tidy_action_server.h"

namespace cobot_command::ros_adapter {

/// To be spun by one thread.
class CellBuilder {
 public:
  /// `hash`: the digest of the artifact that the supervisor runs with.
  CellBuilder(const ros::NodeHandle& node, const ActionQueues& queues, std::string hash);
  ~CellBuilder();  ///< ends the build behind the stage that it is at
  CellBuilder(const CellBuilder&) = delete;
  CellBuilder& operator=(const CellBuilder&) = delete;

 private:
  using Server = TidyActionServer<cobot_command::BuildCellAction>;
  using Handle = Server::GoalHandle;

  void onGoal(Handle goal);
  void onCancel(const Handle& goal);
  void build(const cobot_command::BuildCellGoal& goal, cell::Policy policy);  // on its own thread
  [[nodiscard]] bool runStages(const cobot_command::BuildCellGoal& goal, cell::Policy policy);
  void failed(const std::vector<std::string>& faults);
  void follow();

  std::string hash_;
  std::optional<Handle> goal_;
  std::thread thread_;
  std::atomic<bool> is_cancelled_{false};
  std::mutex mutex_;  // guards the next three
  cobot_command::BuildCellFeedback feedback_;
  cobot_command::BuildCellResult result_;
  bool is_over_ = false;
  std::string told_stage_;
  ros::SteadyTimer following_;
  Server server_;  // last: its callbacks need all the others
};

}  // namespace cobot_command::ros_adapter
