// The node that watches a cell: it stops all robots when two of them come too close, and draws the cell for
// RViz. It is no safety function (cell/monitor/monitor.h).
//
// What it offers is relative to the node's namespace, which is that of the cell. To be spun by one thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/common/result.h"
#include "cobot_command/ros/cell_watch/monitor_parameters.h"

namespace cobot_command::ros_adapter {

class MonitorNode {
 public:
  /// Watches from here on. `self`: the node's private namespace. The faults, each a sentence: files that
  /// cannot be read or used, an artifact of another cell, settings that do not fit the cell.
  [[nodiscard]] static Result<std::unique_ptr<MonitorNode>, std::vector<std::string>> of(
      const ros::NodeHandle& node, const ros::NodeHandle& self, const MonitorParameters& parameters);
  ~MonitorNode();  ///< stop()
  MonitorNode(const MonitorNode&) = delete;
  MonitorNode& operator=(const MonitorNode&) = delete;

  /// Nothing is watched any more: robots go on. It may be called again.
  void stop();

 private:
  class Impl;
  explicit MonitorNode(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::ros_adapter
