// Robots of cell files and their stations.
#pragma once

#include "checks/fault_list.h"

namespace cobot_command::cell {

/// Without stations and program. Throws a YamlFault.
[[nodiscard]] Robot toRobot(const std::string& name, const YAML::Node& node, const FaultList& faults);

/// All stations of a robot whose model is known; faults are collected.
void readStations(const YAML::Node& node, const std::string& field, Robot& robot, FaultList& faults);

/// Its home, once its stations are known; `map`: where the robot stands. Throws a YamlFault.
void checkHome(const YAML::Node& map, const Robot& robot);

}  // namespace cobot_command::cell
