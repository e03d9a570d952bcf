// The private parameters of a node as they were given, before anybody has looked at them; a test makes its
// own, without a master.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include "cobot_command/common/setting.h"

namespace cobot_command::ros_adapter {

struct GivenParameters {
  std::string space;                       ///< of the private ones: "/command_node"
  GivenValues own;                         ///< by their private names, also "space/name"
  std::optional<Given> robot_description;  ///< as the node's namespace has it
};

[[nodiscard]] GivenParameters givenParameters(const ros::NodeHandle& node, const ros::NodeHandle& self);
[[nodiscard]] Given toGiven(const XmlRpc::XmlRpcValue& value);

/// What is wrong with a parameter: its name, what was found, what is allowed.
struct ParameterError {
  std::string message;
};
[[nodiscard]] ParameterError parameterError(const GivenParameters& given, const SettingFault& fault);

/// A sentence for each parameter that no row of the table has, so that nobody relies on a misspelt one.
/// `others`: those of libraries, and of what the node itself writes there.
[[nodiscard]] std::vector<std::string> warningsOfUnknown(const GivenParameters& given,
                                                         const SettingTable& table,
                                                         const std::vector<std::string>& others);

}  // namespace cobot_command::ros_adapter
