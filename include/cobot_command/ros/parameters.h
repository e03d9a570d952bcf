// The private parameters of the nodes, read and checked in one place; README.md lists them.
#pragma once

#include <optional>
#include <string>

#include <ros/node_handle.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/common/result.h"
#include "cobot_command/link/connection.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::ros_adapter {

/// What is wrong with a parameter: its name, what was found, what is allowed.
struct ParameterError {
  std::string message;
};

struct CommandParameters {
  std::optional<arm::ArmModel> arm;  ///< absent: moves are sent without planning them first
  std::string prefix;                ///< of joint and frame names
  std::string robot_ip;              ///< for Connect goals without a host
  int script_port = 5890;            ///< for Connect goals without a port
  bool auto_connect = false;         ///< connect by itself, and keep it up
  bool tf_from_start = true;         ///< listen to tf before a goal asks for a frame
  link::LinkSettings link;
};

struct SimulatorParameters {
  explicit SimulatorParameters(arm::ArmModel model) : arm(std::move(model)) {}

  arm::ArmModel arm;
  std::string prefix;
  simulator::Settings settings;
  std::string bind_address = "127.0.0.1";
  int script_port = 5890;
  int status_port = 5891;
  double time_scale = 1.0;
  double publish_rate = 50.0;  ///< [Hz]
  bool log_traffic = false;    ///< what is sent and received, in words
};

/// `node` gives the namespace for `robot_description` and for the node of a simulated controller, `self` the
/// private parameters. With ~simulated_controller it waits until that node tells its ports.
[[nodiscard]] Result<CommandParameters, ParameterError> readCommandParameters(const ros::NodeHandle& node,
                                                                              const ros::NodeHandle& self);
[[nodiscard]] Result<SimulatorParameters, ParameterError> readSimulatorParameters(
    const ros::NodeHandle& node, const ros::NodeHandle& self);

}  // namespace cobot_command::ros_adapter
