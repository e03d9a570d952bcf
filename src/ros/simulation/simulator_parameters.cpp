#include "cobot_command/ros/simulation/simulator_parameters.h"

#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/ros/shared/robot_parameters.h"

namespace cobot_command::ros_adapter {

SettingTable settingsTable(SimulatorNodeSetup& setup) {
  SettingTable table = runtime::settingsTable(setup.simulator);
  table.push_back(prefixRow(setup.prefix));
  table.push_back({"publish_rate", setting_kinds::real(setup.publish_rate, 0.1, 1000, "Hz"),
                   "rate of the node's own topics"});
  return table;
}

Result<SimulatorParameters, ParameterError> readSimulatorParameters(const GivenParameters& given) {
  SimulatorNodeSetup setup;
  const SettingTable table = settingsTable(setup);
  if (const auto fault = take(table, given.own)) return refuse(parameterError(given, *fault));
  // ~listening is what it tells itself: a run before this one may have left it.
  std::vector<std::string> warnings = warningsOfUnknown(given, table, {"listening"});
  auto arm = armOf({setup.simulator.robot_model, setup.prefix}, given.robot_description, warnings);
  if (!arm) return refuse(parameterError(given, arm.error()));
  if (!*arm) {
    return refuse(parameterError(given, {"robot_model", "is empty, and there is no robot_description",
                                         "the name of a model, or a robot_description"}));
  }
  if (const auto fault = runtime::faultIn(setup.simulator, **arm)) {
    return refuse(parameterError(given, *fault));
  }
  SimulatorParameters parameters(setup, std::move(**arm));
  parameters.warnings = std::move(warnings);
  return parameters;
}

Result<SimulatorParameters, ParameterError> readSimulatorParameters(const ros::NodeHandle& node,
                                                                    const ros::NodeHandle& self) {
  auto parameters = readSimulatorParameters(givenParameters(node, self));
  if (!parameters) return parameters;
  for (const std::string& warning : parameters->warnings) ROS_WARN_STREAM(forPeople(warning));
  return parameters;
}

}  // namespace cobot_command::ros_adapter
