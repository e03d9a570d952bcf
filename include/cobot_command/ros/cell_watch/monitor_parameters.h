// The private parameters of a cell's monitor: one table, read and checked before anything else is created.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/cell/monitor/monitor.h"
#include "cobot_command/common/result.h"
#include "cobot_command/ros/shared/given_parameters.h"

namespace cobot_command::ros_adapter {

struct MonitorParameters {
  std::string cell_file;  ///< absolute path
  /// Whether it stops the robots, or only warns.
  cell::MonitorSettings::Mode mode = cell::MonitorSettings::Mode::Stop;
  std::optional<double> stop_distance;  ///< [m]; nullopt: half of the margin
  std::string artifact;                 ///< absolute path; empty: none
  bool publish_frames = true;           ///< publishes the bases of the robots in tf
  double diagnostic_period = 1.0;       ///< [s]

  std::vector<std::string> warnings;  ///< about values that are valid, but probably a mistake
};

/// A row for each parameter, in the order of the page; `parameters` must outlive the table.
[[nodiscard]] SettingTable settingsTable(MonitorParameters& parameters);

[[nodiscard]] Result<MonitorParameters, ParameterError> readMonitorParameters(const GivenParameters& given);
/// The same from the parameter server; its warnings are logged.
[[nodiscard]] Result<MonitorParameters, ParameterError> readMonitorParameters(const ros::NodeHandle& node,
                                                                              const ros::NodeHandle& self);

}  // namespace cobot_command::ros_adapter
