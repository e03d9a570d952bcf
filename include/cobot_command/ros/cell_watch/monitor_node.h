// The node that monitors a cell: it stops all robots if two of them come too close, and draws the cell for
// RViz. It is not a safety function (cell/monitor/monitor.h).
//
// Its topics and services are relative to the node's namespace, which is that of the cell. It must be spun by
// one thread.
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
  /// Monitoring begins here. `self`: the node's private namespace. The errors, each a sentence: files that
  /// are unreadable or unusable, an artifact of another cell, settings that do not fit the cell.
  [[nodiscard]] static Result<std::unique_ptr<MonitorNode>, std::vector<std::string>> of(
      const ros::NodeHandle& node, const ros::NodeHandle& self, const MonitorParameters& parameters);
  ~MonitorNode();  ///< stop()
  MonitorNode(const MonitorNode&) = delete;
  MonitorNode& operator=(const MonitorNode&) = delete;

  /// Ends the monitoring: robots continue. May be called again.
  void stop();

 private:
  class Impl;
  explicit MonitorNode(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace cobot_command::ros_adapter
