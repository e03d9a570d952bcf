// The private parameters of the simulated controller's node: the settings of tm_simulator, and those that
// only ROS needs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/ros/shared/given_parameters.h"
#include "cobot_command/runtime/simulation/simulator_setup.h"

namespace cobot_command::ros_adapter {

/// The parameters that are read before the model is known.
struct SimulatorNodeSetup {
  runtime::SimulatorSetup simulator;
  std::string prefix;
  double publish_rate = 50.0;  ///< [Hz]
};
/// A row for each parameter, in the order of the page; `setup` must outlive the table.
[[nodiscard]] SettingTable settingsTable(SimulatorNodeSetup& setup);

struct SimulatorParameters : SimulatorNodeSetup {
  SimulatorParameters(SimulatorNodeSetup setup, arm::ArmModel model)
      : SimulatorNodeSetup(std::move(setup)), arm(std::move(model)) {}

  arm::ArmModel arm;
  std::vector<std::string> warnings;  ///< about values that are valid, but probably a mistake
};

[[nodiscard]] Result<SimulatorParameters, ParameterError> readSimulatorParameters(
    const GivenParameters& given);
/// The same from the parameter server; its warnings are logged.
[[nodiscard]] Result<SimulatorParameters, ParameterError> readSimulatorParameters(
    const ros::NodeHandle& node, const ros::NodeHandle& self);

}  // namespace cobot_command::ros_adapter
