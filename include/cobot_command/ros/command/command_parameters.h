// The private parameters of the command node: one table, read and checked before anything else is created.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/command/dynamics.h"
#include "cobot_command/command/exchange_rules.h"
#include "cobot_command/common/result.h"
#include "cobot_command/link/connection.h"
#include "cobot_command/ros/cell/cell_parameters.h"
#include "cobot_command/ros/shared/given_parameters.h"
#include "cobot_command/ros/shared/robot_parameters.h"
#include "cobot_command/ros/tables/table_parameters.h"

namespace cobot_command::ros_adapter {

struct CommandParameters {
  std::string robot_model;  ///< empty: from the robot_description
  std::string prefix;       ///< of joint and frame names
  /// Rotation speed of the TCP at 100 %, as plans use it [rad/s].
  double turn_speed = arm::kUsualTurnSpeed;
  std::string robot_ip;       ///< for connect goals without a host
  int script_port = 5890;     ///< for connect goals without a port
  bool auto_connect = false;  ///< connects automatically, and maintains the connection
  bool tf_from_start = true;  ///< listens to tf before a goal needs a frame
  /// Frame of tf that is the reference of paths in WORLD.
  std::string world_frame = "world";
  std::string simulated_controller;  ///< node whose ports are used; empty: the ports above
  double diagnostic_period = 1.0;    ///< [s]
  link::LinkSettings link;
  TableParameters tables;
  command::ExchangeRules exchange;
  CellParameters cell;
  std::vector<std::string> limit_texts;  ///< ~software_limits
  /// The limits from these texts; nullopt: those of the model.
  std::optional<command::SoftwareLimits> limits;

  std::optional<arm::ArmModel> arm;   ///< nullopt: moves are sent without being planned first
  std::vector<std::string> warnings;  ///< about values that are valid, but probably a mistake
};

/// A row for each parameter, in the order of the page; `parameters` must outlive the table.
[[nodiscard]] SettingTable settingsTable(CommandParameters& parameters);

[[nodiscard]] Result<CommandParameters, ParameterError> readCommandParameters(const GivenParameters& given);
/// Replaces ~script_port and ~status_port by the ports that ~simulated_controller has published, given as
/// `told`. nullopt: both are ports of a server; otherwise the parameters must not be used.
[[nodiscard]] std::optional<SettingFault> takeAnnounced(const GivenValues& told,
                                                        CommandParameters& parameters);
/// The same from the parameter server; its warnings are logged. With ~simulated_controller it waits until
/// that node has published its ports, or until `given_up`.
[[nodiscard]] Result<CommandParameters, ParameterError> readCommandParameters(
    const ros::NodeHandle& node, const ros::NodeHandle& self, const std::function<bool()>& given_up);

}  // namespace cobot_command::ros_adapter
