// What motions refer to, and what the arm carries; as a project starts: no base, no tool, no load.
#pragma once

#include <string>

#include "queue/queue_entry.h"

namespace cobot_command::simulator {

struct ToolAndBase {
  arm::Pose base = arm::Pose::Identity();      ///< in the robot base [m]
  arm::Pose tcp = arm::Pose::Identity();       ///< in the flange [m]
  std::string base_name = script::kRobotBase;  ///< empty when given by value
  std::string tcp_name = script::kNoTool;      ///< likewise
  double tcp_mass = 0;                         ///< [kg], of the tool
  script::ToolInertia tcp_inertia;
  double load = 0;  ///< [kg], of what it holds

  void apply(const BaseChange& change) {
    base = change.pose;
    base_name = change.name;
  }
  void apply(const TcpChange& change) {
    tcp = change.pose;
    tcp_name = change.name;
    tcp_mass = change.mass.value_or(tcp_mass);
    tcp_inertia = change.inertia.value_or(tcp_inertia);
  }
  void apply(const LoadChange& change) { load = change.mass; }
};

}  // namespace cobot_command::simulator
