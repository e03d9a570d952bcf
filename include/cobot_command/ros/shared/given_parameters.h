// The private parameters of a node as given, before any check. A test creates its own, without a master.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <XmlRpcValue.h>
#include <ros/node_handle.h>

#include "cobot_command/common/setting.h"

namespace cobot_command::ros_adapter {

struct GivenParameters {
  std::string space;                       ///< private namespace: "/command_node"
  GivenValues own;                         ///< by their private names, also "space/name"
  std::optional<Given> robot_description;  ///< from the node's namespace
};

[[nodiscard]] GivenParameters givenParameters(const ros::NodeHandle& node, const ros::NodeHandle& self);
[[nodiscard]] Given toGiven(const XmlRpc::XmlRpcValue& value);

/// The error of a parameter: its name, what was found, what is allowed.
struct ParameterError {
  std::string message;
};
[[nodiscard]] ParameterError parameterError(const GivenParameters& given, const SettingFault& fault);

/// A sentence for each parameter that the table does not have, so that a misspelt name is noticed. `others`:
/// parameters of libraries, and those that the node itself writes there.
[[nodiscard]] std::vector<std::string> warningsOfUnknown(const GivenParameters& given,
                                                         const SettingTable& table,
                                                         const std::vector<std::string>& others);

}  // namespace cobot_command::ros_adapter
