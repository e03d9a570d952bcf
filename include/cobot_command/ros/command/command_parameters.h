// The private parameters of the command node: one table, read and checked before anything else is made.
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
  std::string robot_model;                   ///< empty: of the robot_description
  std::string prefix;                        ///< of joint and frame names
  double turn_speed = arm::kUsualTurnSpeed;  ///< of the TCP at 100 %, as plans have it [rad/s]
  std::string robot_ip;                      ///< for Connect goals without a host
  int script_port = 5890;                    ///< for Connect goals without a port
  bool auto_connect = false;                 ///< connect by itself, and keep it up
  bool tf_from_start = true;                 ///< listen to tf before a goal asks for a frame
  std::string world_frame = "world";         ///< of tf, that paths in WORLD are in
  std::string simulated_controller;          ///< the node whose ports are used; empty: the ports above
  double diagnostic_period = 1.0;            ///< [s]
  link::LinkSettings link;
  TableParameters tables;
  command::ExchangeRules exchange;
  CellParameters cell;
  std::vector<std::string> limit_texts;           ///< ~software_limits
  std::optional<command::SoftwareLimits> limits;  ///< what these come to; nothing: those of the model

  std::optional<arm::ArmModel> arm;   ///< absent: moves are sent without planning them first
  std::vector<std::string> warnings;  ///< of what can be used, but was hardly meant so
};

/// A row for each parameter, in the order of the page; `parameters` outlives it.
[[nodiscard]] SettingTable settingsTable(CommandParameters& parameters);

[[nodiscard]] Result<CommandParameters, ParameterError> readCommandParameters(const GivenParameters& given);
/// Puts the ports that ~simulated_controller tells, as it told them, in place of ~script_port and
/// ~status_port. Nothing when something can listen on both; else the parameters are of no use.
[[nodiscard]] std::optional<SettingFault> takeAnnounced(const GivenValues& told,
                                                        CommandParameters& parameters);
/// The same from the parameter server, with its warnings in the log. With ~simulated_controller it waits
/// until that node tells its ports, or until `given_up`.
[[nodiscard]] Result<CommandParameters, ParameterError> readCommandParameters(
    const ros::NodeHandle& node, const ros::NodeHandle& self, const std::function<bool()>& given_up);

}  // namespace cobot_command::ros_adapter
