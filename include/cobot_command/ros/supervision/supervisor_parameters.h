// The parameters of a cell's supervisor.
#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/common/result.h"
#include "cobot_command/common/setting.h"
#include "cobot_command/ros/shared/given_parameters.h"
#include "cobot_command/runtime/cell/cell_supervisor.h"

namespace cobot_command::ros_adapter {

struct SupervisorParameters {
  runtime::SupervisorFiles files;
  runtime::Deciding policy = runtime::Deciding::AsBuilt;
  std::vector<std::string> warnings;
};

/// A row for each parameter; `parameters` must outlive the table.
[[nodiscard]] SettingTable settingsTable(SupervisorParameters& parameters);
[[nodiscard]] Result<SupervisorParameters, ParameterError> readSupervisorParameters(
    const GivenParameters& given);

}  // namespace cobot_command::ros_adapter
