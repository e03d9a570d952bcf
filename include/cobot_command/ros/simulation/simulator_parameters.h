// The private parameters of the simulated controller's node: the settings that tm_simulator has, and what is
// ROS's alone.
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

/// What is told without the model being known yet.
struct SimulatorNodeSetup {
  runtime::SimulatorSetup simulator;
  std::string prefix;
  double publish_rate = 50.0;  ///< [Hz]
};
/// A row for each parameter, in the order of the page; `setup` outlives it.
[[nodiscard]] SettingTable settingsTable(SimulatorNodeSetup& setup);

struct SimulatorParameters : SimulatorNodeSetup {
  SimulatorParameters(SimulatorNodeSetup setup, arm::ArmModel model)
      : SimulatorNodeSetup(std::move(setup)), arm(std::move(model)) {}

  arm::ArmModel arm;
  std::vector<std::string> warnings;  ///< of what can be used, but was hardly meant so
};

[[nodiscard]] Result<SimulatorParameters, ParameterError> readSimulatorParameters(
    const GivenParameters& given);
/// The same from the parameter server, with its warnings in the log.
[[nodiscard]] Result<SimulatorParameters, ParameterError> readSimulatorParameters(
    const ros::NodeHandle& node, const ros::NodeHandle& self);

}  // namespace cobot_command::ros_adapter
