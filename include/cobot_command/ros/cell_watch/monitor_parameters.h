// The private parameters of the monitor of a cell: one table, read and checked before anything else is made.
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
  std::string cell_file;                                                 ///< absolute
  cell::MonitorSettings::Mode mode = cell::MonitorSettings::Mode::Stop;  ///< whether it stops, or only warns
  std::optional<double> stop_distance;                                   ///< [m]; nothing: half of the margin
  std::string artifact;                                                  ///< absolute; empty: none
  bool publish_frames = true;      ///< where the bases of the robots are, in tf
  double diagnostic_period = 1.0;  ///< [s]

  std::vector<std::string> warnings;  ///< of what can be used, but was hardly meant so
};

/// A row for each parameter, in the order of the page; `parameters` outlives it.
[[nodiscard]] SettingTable settingsTable(MonitorParameters& parameters);

[[nodiscard]] Result<MonitorParameters, ParameterError> readMonitorParameters(const GivenParameters& given);
/// The same from the parameter server, with its warnings in the log.
[[nodiscard]] Result<MonitorParameters, ParameterError> readMonitorParameters(const ros::NodeHandle& node,
                                                                              const ros::NodeHandle& self);

}  // namespace cobot_command::ros_adapter
