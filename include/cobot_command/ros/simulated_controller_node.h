// The simulated controller as a ROS node: its true state on topics, the operator's side as services.
//
// Clients command it over TCP like a real one; ROS is only for watching and for the operator.
#pragma once

#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/common/result.h"
#include "cobot_command/ros/conversions.h"
#include "cobot_command/ros/parameters.h"
#include "cobot_command/runtime/simulator_runtime.h"

namespace cobot_command::ros_adapter {

class SimulatedControllerNode {
 public:
  /// Topics, services and parameters are relative to `self`, the node's private namespace.
  SimulatedControllerNode(const ros::NodeHandle& self, SimulatorParameters parameters);
  SimulatedControllerNode(const SimulatedControllerNode&) = delete;
  SimulatedControllerNode& operator=(const SimulatedControllerNode&) = delete;

  /// Serves clients, and writes the ports to ~listening/script_port and ~listening/status_port.
  [[nodiscard]] Result<void, runtime::SimulatorError> start();

 private:
  using Trigger = std_srvs::Trigger;
  using SetBool = std_srvs::SetBool;

  bool runProject(Trigger::Request& request, Trigger::Response& response);
  bool stopProject(Trigger::Request& request, Trigger::Response& response);
  bool setEmergencyStop(SetBool::Request& request, SetBool::Response& response);
  /// Returns when it is done, so that who called sees its effect.
  simulator::OperatorReply operate(const simulator::OperatorAction& action);
  void publish(const simulator::RobotState& state);  // on the simulator's thread

  ros::NodeHandle self_;
  JointNames joint_names_;
  std::string base_frame_;
  ros::Publisher joint_states_;
  ros::Publisher tool_pose_;
  ros::Publisher status_;
  ros::ServiceServer run_project_;
  ros::ServiceServer stop_project_;
  ros::ServiceServer set_emergency_stop_;
  runtime::SimulatorRuntime runtime_;  // last: its thread uses the publishers
};

}  // namespace cobot_command::ros_adapter
